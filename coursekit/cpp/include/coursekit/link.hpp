// The link to the session: questions go up, callbacks come down, on one connection for each thread.
#pragma once
#include "coursekit/frame.hpp"

namespace coursekit
{
/// What the session refused: the kind of its error, and the text.
struct Refused : std::runtime_error
{
  Refused(std::string kind_, const std::string & text)
  : std::runtime_error(text), kind(std::move(kind_)) {}
  std::string kind;
};

/// Ask the session; while it answers, callbacks may run in this thread. Throws Refused.
Unpacker request(const char * what, const Packer & with = {});
/// Tell the session something; nothing comes back.
void note(const char * what, const Packer & with = {});
/// Have the session call `handler` by the number that is returned.
int64_t add_handler(Handler handler);
void remove_handler(int64_t number);

/// Have a session start this program anew where none has, if it can; true.
bool begin_in_session();

/// Let Ctrl-C and `kill` end what waits, as rclcpp::init does.
void catch_signals(bool interrupt, bool terminate);
void release_signals();
/// Whether Ctrl-C, `kill` or the session has asked this program to end.
bool stopping();
/// Count a question that did not wait, so that a loop that only asks cannot stop virtual time.
void poll();
/// Nanoseconds of the session's clock: since the epoch, and since its beginning.
int64_t system_now();
int64_t steady_now();
/// Sleep on the session's clock; false when Ctrl-C came, or the context of that number (not -1) ended meanwhile.
bool sleep_for(int64_t nanoseconds, int64_t context = -1);
/// Whether some node of this program follows /clock, so that ROS time must be asked for.
bool simulated_time();
}  // namespace coursekit
