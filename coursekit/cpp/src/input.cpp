// Standard input: what is typed to the process that stands for this program, asked of the session.
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <streambuf>

#include "state.hpp"

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
