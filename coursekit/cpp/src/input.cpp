// Standard input: what is typed to the process that stands for this program, asked of the session.
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
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
/// As read(2) of a terminal: a line, or what single keys are asked for; EINTR after Ctrl-C.
ssize_t read_input(void * to, size_t size)
{
  Unpacker answer = request("read", Packer{}.i(static_cast<int64_t>(size)));
  if (!answer.i()) {
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
