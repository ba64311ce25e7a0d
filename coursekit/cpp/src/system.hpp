// What each system does in its own way: `posix/` and `windows/` have it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace coursekit
{
/// A connection to the session: a descriptor, or a socket of Windows.
using Connection = std::intptr_t;
constexpr Connection NO_CONNECTION = -1;

/// Connect to what COURSEKIT_LINK names; NO_CONNECTION where nobody listens there.
Connection open_connection(const char * address);
/// Send some of it, at least a byte; 0 where the other end has gone.
size_t send_some(Connection connection, const char * data, size_t size);
/// Send all of it; false where the other end has gone.
inline bool send_all(Connection connection, const char * data, size_t size)
{
  while (size) {
    size_t sent = send_some(connection, data, size);
    if (!sent) {
      return false;
    }
    data += sent;
    size -= sent;
  }
  return true;
}
/// Receive what has come, at least a byte and at most so many; 0 where the other end has gone.
size_t receive_some(Connection connection, char * to, size_t size);
void close_connection(Connection connection);

/// Become `ros2 run` of this program with its own words; returns where that does not work.
void restart_in_session();
/// Have what is printed leave the program as it does in a terminal.
void print_as_in_a_terminal();
/// End this program as a signal ends one that does not catch it; returns where its own handler has it go on.
void obey_signal(int number);

/// Start a thread that the session need not know of.
void start_real_thread(void * (*function)(void *), void * argument);
/// Nanoseconds since the epoch, and since some beginning, whatever the session's clock says.
int64_t real_system_ns();
int64_t real_steady_ns();

/// Load a library; nullptr and the reason where that fails.
void * load_library(const std::string & path, std::string & reason);
/// Something that a loaded library exports; nullptr where it has none of that name.
void * symbol_of(void * library, const std::string & name);
void unload_library(void * library);
/// The file that runs; empty where the system does not say.
std::string executable();
}  // namespace coursekit
