// Windows' clocks and sleeps on the session's clock while that is virtual, and Ctrl-C.
#include <windows.h>

#include <signal.h>
#include <stdlib.h>
#include <time.h>

#include <chrono>

#include "../state.hpp"

namespace coursekit
{
namespace
{
constexpr int64_t UNIX_BEGINNING = 116444736000000000;  // in Windows' hundreds of nanoseconds since 1601
constexpr int ENDED_BY_CTRL_C = static_cast<int>(0xC000013A);  // what Windows says of a program that Ctrl-C has ended
std::atomic<bool> g_interrupt{false}, g_terminate{false};

/// Ctrl-C of a console, in a thread that Windows makes for it.
BOOL WINAPI on_console(DWORD event)
{
  if ((event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT) && g_interrupt) {
    g_stop = true;
    return TRUE;
  }
  return FALSE;
}
/// Whether the program has a handler of its own for a signal.
bool has_own_handler(int number)
{
  auto handler = signal(number, SIG_DFL);
  signal(number, handler);
  return handler != SIG_DFL && handler != SIG_ERR;
}
}  // namespace

void catch_signals(bool interrupt, bool terminate)
{
  g_interrupt = interrupt;
  g_terminate = terminate;
  SetConsoleCtrlHandler(on_console, TRUE);
}
void release_signals() {g_interrupt = g_terminate = false;}
void obey_signal(int number)
{
  if (number == SIGINT ? g_interrupt : g_terminate) {
    g_stop = true;
  } else if (has_own_handler(number)) {
    raise(number);
  } else {
    TerminateProcess(GetCurrentProcess(), static_cast<UINT>(ENDED_BY_CTRL_C));
  }
}
int64_t real_system_ns()
{
  FILETIME time;
  GetSystemTimePreciseAsFileTime(&time);
  int64_t since_1601 = (static_cast<int64_t>(time.dwHighDateTime) << 32) | time.dwLowDateTime;
  return (since_1601 - UNIX_BEGINNING) * 100;
}
int64_t real_steady_ns()
{
  LARGE_INTEGER count, per_second;
  QueryPerformanceCounter(&count);
  QueryPerformanceFrequency(&per_second);
  int64_t whole = count.QuadPart / per_second.QuadPart, rest = count.QuadPart % per_second.QuadPart;
  return whole * 1000000000 + rest * 1000000000 / per_second.QuadPart;
}
}  // namespace coursekit

// All of libc++'s file for these clocks, so that the linker leaves that one out.
_LIBCPP_BEGIN_NAMESPACE_STD
namespace chrono
{
system_clock::time_point system_clock::now() noexcept
{
  return time_point(duration_cast<duration>(nanoseconds(coursekit::system_now())));
}
time_t system_clock::to_time_t(const time_point & t) noexcept
{
  return static_cast<time_t>(duration_cast<seconds>(t.time_since_epoch()).count());
}
system_clock::time_point system_clock::from_time_t(time_t t) noexcept {return time_point(seconds(t));}
steady_clock::time_point steady_clock::now() noexcept
{
  return time_point(nanoseconds(coursekit::steady_now()));
}
}  // namespace chrono
_LIBCPP_END_NAMESPACE_STD

// What C programs ask. Each is there by its name, and as the pointer through which a function of a library is called.
extern "C" {
void WINAPI coursekit_sleep(DWORD milliseconds) __asm__("Sleep");
__time64_t __cdecl coursekit_time(__time64_t * to) __asm__("_time64");

void WINAPI coursekit_sleep(DWORD milliseconds)
{
  if (coursekit::g_state.is_virtual) {
    coursekit::sleep_for(milliseconds * 1000000LL);
  } else {
    SleepEx(milliseconds, FALSE);
  }
}
__time64_t __cdecl coursekit_time(__time64_t * to)
{
  __time64_t now = coursekit::system_now() / 1000000000;
  if (to) {
    *to = now;
  }
  return now;
}
void (WINAPI * __imp_Sleep)(DWORD) = coursekit_sleep;
__time64_t (__cdecl * __imp__time64)(__time64_t *) = coursekit_time;
}
