// A Unix socket to the session, and standard output.
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <fstream>
#include <vector>

#include "../system.hpp"

#ifdef MSG_NOSIGNAL
#define COURSEKIT_SEND_FLAGS MSG_NOSIGNAL
#else
#define COURSEKIT_SEND_FLAGS 0  // macOS has a setting of the socket for that
#endif

namespace coursekit
{
Connection open_connection(const char * address)
{
  int fd = socket(AF_UNIX, SOCK_STREAM, 0);
  fcntl(fd, F_SETFD, FD_CLOEXEC);
#ifdef SO_NOSIGPIPE
  int on = 1;
  setsockopt(fd, SOL_SOCKET, SO_NOSIGPIPE, &on, sizeof(on));
#endif
  sockaddr_un where{};
  where.sun_family = AF_UNIX;
  strncpy(where.sun_path, address, sizeof(where.sun_path) - 1);
  return connect(fd, reinterpret_cast<sockaddr *>(&where), sizeof(where)) ? NO_CONNECTION : fd;
}
size_t send_some(Connection connection, const char * data, size_t size)
{
  ssize_t sent;
  do {
    sent = send(static_cast<int>(connection), data, size, COURSEKIT_SEND_FLAGS);
  } while (sent < 0 && errno == EINTR);
  return sent < 0 ? 0 : static_cast<size_t>(sent);
}
size_t receive_some(Connection connection, char * to, size_t size)
{
  ssize_t got;
  do {
    got = recv(static_cast<int>(connection), to, size, 0);
  } while (got < 0 && errno == EINTR);
  return got < 0 ? 0 : static_cast<size_t>(got);
}
void close_connection(Connection connection) {close(static_cast<int>(connection));}

void print_as_in_a_terminal() {setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);}

void restart_in_session()
{
  std::ifstream told("/proc/self/cmdline");  // Linux alone has it
  std::vector<std::string> words;
  for (std::string word; std::getline(told, word, '\0'); ) {
    words.push_back(word);
  }
  const std::string path = executable();
  if (words.empty() || path.empty()) {
    return;
  }
  const size_t slash = path.rfind('/');
  words.front() = path.substr(slash + 1);
  words.insert(words.begin(), {"ros2", "run", path.substr(0, slash + 1)});
  std::vector<char *> command;
  for (std::string & word : words) {
    command.push_back(word.data());
  }
  command.push_back(nullptr);
  execvp("ros2", command.data());
}
}  // namespace coursekit
