// What the parts of the runtime share: the session's time and wishes, and this program's connections.
#pragma once
#include <time.h>

#include <atomic>
#include <cstdint>

#include "coursekit/link.hpp"
#include "system.hpp"

namespace coursekit
{
enum Flag {VIRTUAL = 1, STOPPING = 2, SIMULATED = 4};

/// The session's clock and flags as the last frame told them.
struct State
{
  std::atomic<int64_t> system{0}, steady{0}, flags{0};
  std::atomic<int> blocked{0};
  std::atomic<bool> is_virtual{false};
};
extern State g_state;
/// Whether Ctrl-C or `kill` has come.
extern std::atomic<bool> g_stop;

/// What the connections of threads are for; the first byte that goes up.
enum Purpose : char {MAIN = 'M', THREAD = 'T', WORKER = 'W', CONTROL = 'C'};
/// Connect to the session; ends the program where it cannot.
Connection connect_to_session(Purpose purpose);
/// Which state of the runtime this is, behind a mark that ends with a colon.
const char * age();
/// Give the calling thread a connection that was made for it, before it asks anything.
void use_connection(Connection connection);
/// Wait until the session lets the calling thread begin.
void begin_thread();
/// Run what the session calls in this thread, until it closes the connection.
void serve_calls();
}  // namespace coursekit
