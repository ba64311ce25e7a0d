// Standard input: what is typed to the process that stands for this program, asked of the session.
#include <conio.h>
#include <stdio.h>
#include <stdlib.h>

#include <iostream>
#include <streambuf>

#include "../state.hpp"

namespace coursekit
{
namespace
{
constexpr int64_t LINE = 4096;  // who asks for so much wants a line
bool linked()
{
  static const bool is = getenv("COURSEKIT_LINK") != nullptr;
  return is;
}
/// A line, or one key; empty when Ctrl-C came, or the end.
std::string typed(bool by_keys)
{
  Unpacker answer = request("read", Packer{}.i(by_keys ? 1 : LINE).i(by_keys).i(-1));
  return answer.i() ? answer.s() : "";
}
/// std::cin, line by line.
class FromSession : public std::streambuf
{
protected:
  int_type underflow() override
  {
    line_ = typed(false);
    setg(&line_[0], &line_[0], &line_[0] + line_.size());
    return line_.empty() ? traits_type::eof() : traits_type::to_int_type(line_[0]);
  }

private:
  std::string line_;
};
struct AtStart
{
  AtStart()
  {
    if (linked()) {
      std::cin.rdbuf(new FromSession);
    }
  }
  std::ios_base::Init streams;
} at_start;

bool g_wants_keys = false;
void want_keys()
{
  if (!g_wants_keys) {
    g_wants_keys = true;
    note("want_keys", Packer{}.i(0));
  }
}
int key()
{
  want_keys();
  std::string one = typed(true);
  return one.empty() ? 3 : static_cast<unsigned char>(one[0]);  // Ctrl-C is a key there
}
int is_there_a_key()
{
  want_keys();
  return static_cast<int>(request("has_input", Packer{}.i(0)).i());
}
}  // namespace
}  // namespace coursekit

// Each is there by its names, and as the pointer through which a function of a library is called.
extern "C" {
int coursekit_getch() __asm__("_getch");
int coursekit_kbhit() __asm__("_kbhit");

int coursekit_getch() {return coursekit::key();}
int coursekit_kbhit() {return coursekit::is_there_a_key();}
int getch() {return coursekit::key();}
int kbhit() {return coursekit::is_there_a_key();}
int (__cdecl * __imp__getch)() = coursekit_getch;
int (__cdecl * __imp__kbhit)() = coursekit_kbhit;
}
