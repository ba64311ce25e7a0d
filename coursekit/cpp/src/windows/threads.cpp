// Threads, locks and waiting as libc++ asks for them on Windows: of the session while time is virtual, else of Windows.
//
// All that libc++ has in its own file for this is here, so that the linker leaves that one out. The names are libc++'s.
#include <windows.h>

#include <errno.h>
#include <process.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "../state.hpp"
#include "../threads.hpp"

namespace
{
using Function = void * (*)(void *);
struct Start
{
  Function function;
  void * argument;
  coursekit::Connection connection;
};
unsigned __stdcall begin(void * given)
{
  Start start = *static_cast<Start *>(given);
  delete static_cast<Start *>(given);
  if (start.connection != coursekit::NO_CONNECTION) {
    coursekit::use_connection(start.connection);
    coursekit::begin_thread();
  }
  start.function(start.argument);
  return 0;
}
HANDLE begun(Function function, void * argument, coursekit::Connection connection, unsigned * id)
{
  auto * start = new Start{function, argument, connection};
  auto handle = reinterpret_cast<HANDLE>(_beginthreadex(nullptr, 0, begin, start, 0, id));
  if (!handle) {
    delete start;
  }
  return handle;
}
int64_t number_of(HANDLE thread) {return GetThreadId(thread);}
int error_unless(bool done) {return done ? 0 : static_cast<int>(GetLastError());}
PSRWLOCK lock_in(void ** place) {return reinterpret_cast<PSRWLOCK>(place);}
PCONDITION_VARIABLE condition_in(void ** place) {return reinterpret_cast<PCONDITION_VARIABLE>(place);}
LPCRITICAL_SECTION section_in(void * place) {return reinterpret_cast<LPCRITICAL_SECTION>(place);}
DWORD milliseconds_in(int64_t nanoseconds)
{
  int64_t most = INFINITE - 1, whole = (nanoseconds + 999999) / 1000000;
  return static_cast<DWORD>(std::clamp<int64_t>(whole, 0, most));
}
BOOL CALLBACK run_once(PINIT_ONCE, void * routine, void **)
{
  reinterpret_cast<void (*)()>(routine)();
  return TRUE;
}
}  // namespace

namespace coursekit
{
void start_real_thread(Function function, void * argument)
{
  unsigned id;
  if (HANDLE thread = begun(function, argument, NO_CONNECTION, &id)) {
    CloseHandle(thread);
  }
}
}  // namespace coursekit

_LIBCPP_BEGIN_NAMESPACE_STD

// -- locks

bool __libcpp_mutex_trylock(__libcpp_mutex_t * m) {return TryAcquireSRWLockExclusive(lock_in(m));}
int __libcpp_mutex_lock(__libcpp_mutex_t * m)
{
  if (!coursekit::g_state.is_virtual) {
    AcquireSRWLockExclusive(lock_in(m));
    return 0;
  }
  while (!__libcpp_mutex_trylock(m)) {
    coursekit::block(m, -1);
  }
  return 0;
}
int __libcpp_mutex_unlock(__libcpp_mutex_t * m)
{
  ReleaseSRWLockExclusive(lock_in(m));
  coursekit::unblock(m, false);
  return 0;
}
int __libcpp_mutex_destroy(__libcpp_mutex_t *) {return 0;}

int __libcpp_recursive_mutex_init(__libcpp_recursive_mutex_t * m)
{
  InitializeCriticalSection(section_in(m));
  return 0;
}
bool __libcpp_recursive_mutex_trylock(__libcpp_recursive_mutex_t * m) {return TryEnterCriticalSection(section_in(m));}
int __libcpp_recursive_mutex_lock(__libcpp_recursive_mutex_t * m)
{
  if (!coursekit::g_state.is_virtual) {
    EnterCriticalSection(section_in(m));
    return 0;
  }
  while (!__libcpp_recursive_mutex_trylock(m)) {
    coursekit::block(m, -1);
  }
  return 0;
}
int __libcpp_recursive_mutex_unlock(__libcpp_recursive_mutex_t * m)
{
  LeaveCriticalSection(section_in(m));
  coursekit::unblock(m, false);
  return 0;
}
int __libcpp_recursive_mutex_destroy(__libcpp_recursive_mutex_t * m)
{
  DeleteCriticalSection(section_in(m));
  return 0;
}

// -- waiting for what another thread does

int __libcpp_condvar_signal(__libcpp_condvar_t * c)
{
  WakeConditionVariable(condition_in(c));
  coursekit::unblock(c, false);
  return 0;
}
int __libcpp_condvar_broadcast(__libcpp_condvar_t * c)
{
  WakeAllConditionVariable(condition_in(c));
  coursekit::unblock(c, true);
  return 0;
}
/// Wait on the virtual clock, at most so long (negative: without end).
static int wait_for_session(__libcpp_condvar_t * c, __libcpp_mutex_t * m, int64_t left)
{
  __libcpp_mutex_unlock(m);
  bool woken = coursekit::block(c, left < 0 ? -1 : coursekit::g_state.steady + left);
  __libcpp_mutex_lock(m);
  return woken ? 0 : ETIMEDOUT;
}
int __libcpp_condvar_wait(__libcpp_condvar_t * c, __libcpp_mutex_t * m)
{
  if (coursekit::g_state.is_virtual) {
    wait_for_session(c, m, -1);
    return 0;
  }
  return error_unless(SleepConditionVariableSRW(condition_in(c), lock_in(m), INFINITE, 0));
}
int __libcpp_condvar_timedwait(__libcpp_condvar_t * c, __libcpp_mutex_t * m, __libcpp_timespec_t * until)
{
  int64_t end = until->tv_sec * 1000000000LL + until->tv_nsec;
  if (coursekit::g_state.is_virtual) {
    return wait_for_session(c, m, std::max<int64_t>(end - coursekit::g_state.system, 0));
  }
  DWORD left = milliseconds_in(end - coursekit::real_system_ns());
  int error = error_unless(SleepConditionVariableSRW(condition_in(c), lock_in(m), left, 0));
  return error == ERROR_TIMEOUT ? ETIMEDOUT : error;
}
int __libcpp_condvar_destroy(__libcpp_condvar_t *) {return 0;}

int __libcpp_execute_once(__libcpp_exec_once_flag * flag, void (* routine)())
{
  return error_unless(
    InitOnceExecuteOnce(reinterpret_cast<PINIT_ONCE>(flag), run_once, reinterpret_cast<void *>(routine), nullptr));
}

// -- threads

bool __libcpp_thread_id_equal(__libcpp_thread_id one, __libcpp_thread_id other) {return one == other;}
bool __libcpp_thread_id_less(__libcpp_thread_id one, __libcpp_thread_id other) {return one < other;}
bool __libcpp_thread_isnull(const __libcpp_thread_t * thread) {return *thread == nullptr;}
__libcpp_thread_id __libcpp_thread_get_current_id() {return static_cast<__libcpp_thread_id>(GetCurrentThreadId());}
__libcpp_thread_id __libcpp_thread_get_id(const __libcpp_thread_t * thread)
{
  return static_cast<__libcpp_thread_id>(GetThreadId(*thread));
}
int __libcpp_thread_create(__libcpp_thread_t * thread, void * (*function)(void *), void * argument)
{
  unsigned id;
  if (!coursekit::g_state.is_virtual) {
    return error_unless((*thread = begun(function, argument, coursekit::NO_CONNECTION, &id)));
  }
  *thread = begun(function, argument, coursekit::connect_to_session(coursekit::THREAD), &id);
  if (*thread) {
    coursekit::request("thread", coursekit::Packer{}.i(id));
  }
  return error_unless(*thread);
}
int __libcpp_thread_join(__libcpp_thread_t * thread)
{
  if (coursekit::g_state.is_virtual) {
    coursekit::request("join", coursekit::Packer{}.i(number_of(*thread)));
  }
  bool ended = WaitForSingleObject(*thread, INFINITE) != WAIT_FAILED;
  return error_unless(ended && CloseHandle(*thread));
}
int __libcpp_thread_detach(__libcpp_thread_t * thread) {return error_unless(CloseHandle(*thread));}
void __libcpp_thread_yield() {SwitchToThread();}
void __libcpp_thread_sleep_for(const chrono::nanoseconds & time)
{
  if (coursekit::g_state.is_virtual) {
    coursekit::sleep_for(time.count());
  } else {
    SleepEx(milliseconds_in(time.count()), FALSE);
  }
}

// -- what belongs to a thread

int __libcpp_tls_create(__libcpp_tls_key * key, void (_LIBCPP_TLS_DESTRUCTOR_CC * at_end)(void *))
{
  DWORD made = FlsAlloc(at_end);
  *key = static_cast<__libcpp_tls_key>(made);
  return error_unless(made != FLS_OUT_OF_INDEXES);
}
void * __libcpp_tls_get(__libcpp_tls_key key) {return FlsGetValue(static_cast<DWORD>(key));}
int __libcpp_tls_set(__libcpp_tls_key key, void * value) {return error_unless(FlsSetValue(static_cast<DWORD>(key), value));}

_LIBCPP_END_NAMESPACE_STD
