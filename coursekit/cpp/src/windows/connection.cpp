// A loopback port and its token instead of a Unix socket, and standard output.
#include <winsock2.h>
#include <ws2tcpip.h>

#include <fcntl.h>
#include <io.h>
#include <stdio.h>
#include <stdlib.h>

#include <algorithm>

#include "../system.hpp"

namespace coursekit
{
namespace
{
constexpr size_t MOST = 1 << 20;  // Windows counts bytes of one call in an int
void begin_sockets()
{
  static const int begun = [] {
      WSADATA about;
      return WSAStartup(MAKEWORD(2, 2), &about);
    }();
  (void)begun;
}
SOCKET connected(unsigned short port)
{
  SOCKET made = socket(AF_INET, SOCK_STREAM, IPPROTO_TCP);
  SetHandleInformation(reinterpret_cast<HANDLE>(made), HANDLE_FLAG_INHERIT, 0);
  int on = 1;  // questions are small, and each is waited for
  setsockopt(made, IPPROTO_TCP, TCP_NODELAY, reinterpret_cast<const char *>(&on), sizeof(on));
  sockaddr_in where{};
  where.sin_family = AF_INET;
  where.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  where.sin_port = htons(port);
  return connect(made, reinterpret_cast<sockaddr *>(&where), sizeof(where)) ? INVALID_SOCKET : made;
}
}  // namespace

/// The address is PORT:TOKEN, and the token is what the session wants to hear first.
Connection open_connection(const char * address)
{
  begin_sockets();
  std::string whole = address;
  size_t colon = whole.find(':');
  if (colon == std::string::npos) {
    return NO_CONNECTION;
  }
  SOCKET made = connected(static_cast<unsigned short>(atoi(whole.c_str())));
  std::string token = whole.substr(colon + 1);
  if (made == INVALID_SOCKET || !send_all(static_cast<Connection>(made), token.data(), token.size())) {
    return NO_CONNECTION;
  }
  return static_cast<Connection>(made);
}
size_t send_some(Connection connection, const char * data, size_t size)
{
  int sent = send(static_cast<SOCKET>(connection), data, static_cast<int>(std::min(size, MOST)), 0);
  return sent < 0 ? 0 : static_cast<size_t>(sent);
}
size_t receive_some(Connection connection, char * to, size_t size)
{
  int got = recv(static_cast<SOCKET>(connection), to, static_cast<int>(std::min(size, MOST)), 0);
  return got < 0 ? 0 : static_cast<size_t>(got);
}
void close_connection(Connection connection) {closesocket(static_cast<SOCKET>(connection));}

/// At once, for Windows knows no buffer that ends with the line; and each line ends as it does on a robot.
void restart_in_session() {}  // a process cannot become another there
void print_as_in_a_terminal()
{
  setvbuf(stdout, nullptr, _IONBF, 0);
  _setmode(_fileno(stdout), _O_BINARY);
  _setmode(_fileno(stderr), _O_BINARY);
}

}  // namespace coursekit
