// Standard input: what is typed to the process that stands for this program, asked of the session.
#include <errno.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <streambuf>

#include "real.hpp"

namespace coursekit
{
namespace
{
bool linked()
{
  static const bool is = getenv("COURSEKIT_LINK") != nullptr;
  return is;
}
/// The terminal's settings as the program left them: whole lines at first.
termios & terminal()
{
  static termios * settings = [] {
      auto * made = new termios{};
      made->c_iflag = ICRNL | IXON;
      made->c_oflag = OPOST | ONLCR;
      made->c_cflag = CS8 | CREAD;
      made->c_lflag = ICANON | ECHO | ISIG | IEXTEN;
      made->c_cc[VMIN] = 1;
      return made;
    }();
  return *settings;
}
constexpr int64_t TENTH_NS = 100000000;
/// As read(2) of a terminal: a line, or what single keys are asked for; EINTR after Ctrl-C, but where no key need come.
ssize_t read_input(void * to, size_t size)
{
  bool by_keys = !(terminal().c_lflag & ICANON), may_be_none = by_keys && terminal().c_cc[VMIN] == 0;
  int64_t patience = may_be_none ? terminal().c_cc[VTIME] * TENTH_NS : -1;
  Unpacker answer = request("read", Packer{}.i(static_cast<int64_t>(size)).i(by_keys).i(patience));
  if (!answer.i()) {
    if (may_be_none) {
      return 0;
    }
    errno = EINTR;
    return -1;
  }
  std::string data = answer.s();
  memcpy(to, data.data(), std::min(size, data.size()));
  return static_cast<ssize_t>(data.size());
}
/// Whether something is typed that was not read, or is within the time (negative: whenever it comes).
bool has_input(int64_t patience) {return request("has_input", Packer{}.i(patience)).i();}
/// Whether a set of descriptors holds standard input alone.
bool only_input(int count, const fd_set * reads, const fd_set * writes, const fd_set * exceptions)
{
  for (int fd = 0; fd < count; ++fd) {
    bool other = (writes && FD_ISSET(fd, writes)) || (exceptions && FD_ISSET(fd, exceptions));
    if (other || (reads && FD_ISSET(fd, reads)) != (fd == STDIN_FILENO)) {
      return false;
    }
  }
  return count > 0;
}
/// std::cin, character by character from the C library's stdin, so that both may be used.
class FromStdin : public std::streambuf
{
protected:
  int_type underflow() override
  {
    int c = getc(stdin);
    return c == EOF ? traits_type::eof() : ungetc(c, stdin);
  }
  int_type uflow() override
  {
    int c = getc(stdin);
    last_ = c;
    return c == EOF ? traits_type::eof() : c;
  }
  int_type pbackfail(int_type c) override
  {
    int back = c == traits_type::eof() ? last_ : c;
    last_ = EOF;
    return back == EOF ? traits_type::eof() : ungetc(back, stdin);
  }

private:
  int last_ = EOF;
};
#ifdef __GLIBC__
ssize_t read_cookie(void *, char * to, size_t size) {return read_input(to, size);}
struct AtStart
{
  AtStart()
  {
    if (!linked()) {
      return;
    }
    cookie_io_functions_t functions{};
    functions.read = read_cookie;
    if (FILE * asked = fopencookie(nullptr, "r", functions)) {
      stdin = asked;  // the C library's own functions do not call read() by its name
      std::cin.rdbuf(new FromStdin);
    }
  }
  std::ios_base::Init streams;
} at_start;
#endif
}  // namespace
}  // namespace coursekit

extern "C" ssize_t read(int fd, void * to, size_t size)
{
  static std::atomic<void *> known{nullptr};
  if (fd == STDIN_FILENO && coursekit::linked()) {
    return coursekit::read_input(to, size);
  }
  return coursekit::real<decltype(&read)>(known, "read")(fd, to, size);
}

extern "C" int tcgetattr(int fd, termios * settings)
{
  static std::atomic<void *> known{nullptr};
  if (fd == STDIN_FILENO && coursekit::linked()) {
    *settings = coursekit::terminal();
    return 0;
  }
  return coursekit::real<decltype(&tcgetattr)>(known, "tcgetattr")(fd, settings);
}
extern "C" int tcsetattr(int fd, int when, const termios * settings)
{
  static std::atomic<void *> known{nullptr};
  if (fd == STDIN_FILENO && coursekit::linked()) {
    coursekit::terminal() = *settings;
    if (!(settings->c_lflag & ICANON)) {
      coursekit::note("want_keys", coursekit::Packer{}.i(!(settings->c_lflag & ISIG)));
    }
    return 0;
  }
  return coursekit::real<decltype(&tcsetattr)>(known, "tcsetattr")(fd, when, settings);
}

// Programs look for keys before they read them. (It is a C function, as its header says: a Mac's gives it another name.)
int select(
  int count, fd_set * __restrict reads, fd_set * __restrict writes, fd_set * __restrict exceptions, timeval * __restrict timeout)
{
  static std::atomic<void *> known{nullptr};
  if (!coursekit::linked() || !coursekit::only_input(count, reads, writes, exceptions)) {
    return coursekit::real<decltype(&select)>(known, "select")(count, reads, writes, exceptions, timeout);
  }
  int64_t patience = timeout ? timeout->tv_sec * 1000000000LL + timeout->tv_usec * 1000LL : -1;
  if (coursekit::has_input(patience)) {
    return 1;
  }
  FD_CLR(STDIN_FILENO, reads);
  return 0;
}
extern "C" int poll(pollfd * all, nfds_t count, int timeout)
{
  static std::atomic<void *> known{nullptr};
  if (!coursekit::linked() || count != 1 || all->fd != STDIN_FILENO || !(all->events & POLLIN)) {
    return coursekit::real<decltype(&poll)>(known, "poll")(all, count, timeout);
  }
  bool came = coursekit::has_input(timeout < 0 ? -1 : timeout * 1000000LL);
  all->revents = static_cast<short>(came ? POLLIN : 0);  // NOLINT: pollfd's own type
  return came;
}
#ifdef __GLIBC__  // its stdin is one of ours, which has no number of its own
extern "C" int fileno(FILE * stream) noexcept
{
  static std::atomic<void *> known{nullptr};
  if (stream == stdin && coursekit::linked()) {
    return STDIN_FILENO;
  }
  return coursekit::real<int (*)(FILE *)>(known, "fileno")(stream);
}
#endif
