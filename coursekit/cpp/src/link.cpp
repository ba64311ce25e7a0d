// The connections to the session, one for each thread, and what is called over them.
//
// A frame is: length of the rest (4 bytes), kind (1), then
//   up:   'Q' question | 'N' note: name s, packed words;  'R' return of a callback: packed;  'E' it threw
//   down: 'A' answer | 'X' refusal (kind s, text s) | 'C' call (handler i), each after system i, steady i, flags i
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>

#include "state.hpp"

namespace coursekit
{
State g_state;

namespace
{
struct Handlers
{
  std::mutex lock;
  std::map<int64_t, std::shared_ptr<Handler>> by_number;
  int64_t next = 1;
};
Handlers & handlers()
{
  static Handlers * all = new Handlers;  // never destroyed: other threads may still look
  return *all;
}
std::shared_ptr<Handler> handler_of(int64_t number)
{
  std::lock_guard<std::mutex> hold(handlers().lock);
  auto found = handlers().by_number.find(number);
  return found == handlers().by_number.end() ? nullptr : found->second;
}

struct Closed {};

class Link
{
public:
  explicit Link(Connection connection)
  : connection_(connection) {}
  ~Link() {close_connection(connection_);}

  Unpacker ask(const char * what, const Packer & with)
  {
    send('Q', Packer{}.s(what).bytes + with.bytes);
    return wait();
  }
  void note(const char * what, const Packer & with) {send('N', Packer{}.s(what).bytes + with.bytes);}
  Unpacker wait()
  {
    for (;;) {
      Unpacker frame = receive();
      char kind = frame.bytes[0];
      frame.at = 1;
      g_state.system = frame.i();
      g_state.steady = frame.i();
      g_state.flags = frame.i();
      g_state.is_virtual = g_state.flags & VIRTUAL;
      if (kind == 'A') {
        return frame;
      }
      if (kind == 'X') {
        std::string name = frame.s();
        throw Refused(name, frame.s());
      }
      call(frame);
    }
  }

private:
  void call(Unpacker & frame)
  {
    std::shared_ptr<Handler> handler = handler_of(frame.i());
    Packer result;
    try {
      if (handler) {
        (*handler)(frame, result);
      }
    } catch (...) {  // it leaves through the program's own spin(), as in rclcpp
      send('E', "");
      throw;
    }
    send('R', result.bytes);
  }
  void send(char kind, const std::string & body)
  {
    fflush(stdout);
    uint32_t size = static_cast<uint32_t>(body.size() + 1);
    std::string frame(reinterpret_cast<const char *>(&size), 4);
    frame += kind;
    frame += body;
    if (!send_all(connection_, frame.data(), frame.size())) {
      throw Closed();
    }
  }
  Unpacker receive()
  {
    uint32_t size;
    read_exactly(reinterpret_cast<char *>(&size), 4);
    Unpacker frame{std::string(size, '\0')};
    read_exactly(&frame.bytes[0], size);
    return frame;
  }
  void read_exactly(char * to, size_t n)
  {
    while (n) {
      if (begin_ == end_) {
        fill();
      }
      size_t part = std::min(n, end_ - begin_);
      memcpy(to, buffer_ + begin_, part);
      begin_ += part;
      to += part;
      n -= part;
    }
  }
  void fill()
  {
    begin_ = 0;
    end_ = receive_some(connection_, buffer_, sizeof(buffer_));
    if (!end_) {
      throw Closed();
    }
  }

  Connection connection_;
  char buffer_[65536];
  size_t begin_ = 0, end_ = 0;
};

thread_local Connection t_connection = NO_CONNECTION;
thread_local bool t_is_main = false;
thread_local Link * t_link = nullptr;
/// Closes a thread's connection when it ends. The main thread's stays: global nodes are destroyed after what is thread_local.
struct AtThreadEnd
{
  ~AtThreadEnd()
  {
    if (!t_is_main) {
      delete t_link;
      t_link = nullptr;
    }
  }
  bool is_used = false;
};
thread_local AtThreadEnd t_end;
Link & link()
{
  if (!t_link) {
    t_end.is_used = true;
    bool given = t_connection != NO_CONNECTION;
    t_link = new Link(given ? t_connection : connect_to_session(THREAD));
    t_link->wait();  // the session says when this thread may begin
  }
  return *t_link;
}
/// Where the session has ended, or cut this program off, nothing more can be done.
template<class F>
auto guarded(F talk)
{
  try {
    return talk();
  } catch (const Closed &) {
    _Exit(1);
  }
}

void * work(void *)
{
  use_connection(connect_to_session(WORKER));
  try {
    serve_calls();
  } catch (const Closed &) {
  }
  return nullptr;
}
/// Makes a thread whenever the session has a callback for which the program has none, and obeys a signal that comes this way.
void * obey(void * control)
{
  char wish;
  while (receive_some(reinterpret_cast<Connection>(control), &wish, 1)) {
    if (wish == WORKER) {
      start_real_thread(work, nullptr);
    } else {
      obey_signal(wish);
    }
  }
  return nullptr;
}

/// Programs are looked at for this before they are started: one of an older runtime is to be built again.
__attribute__((used)) const volatile char g_age[] = "coursekit-runtime:" COURSEKIT_KEY;

struct AtStart
{
  AtStart()
  {
    print_as_in_a_terminal();
    if (!getenv("COURSEKIT_LINK")) {
      return;
    }
    Connection control = connect_to_session(CONTROL);
    use_connection(connect_to_session(MAIN));
    t_is_main = true;
    begin_thread();
    start_real_thread(obey, reinterpret_cast<void *>(control));
  }
} at_start;
}  // namespace

bool begin_in_session()
{
  if (!getenv("COURSEKIT_LINK")) {
    restart_in_session();
  }
  return true;
}

const char * age() {return const_cast<const char *>(g_age);}

Connection connect_to_session(Purpose purpose)
{
  const char * address = getenv("COURSEKIT_LINK");
  if (!address) {
    restart_in_session();
    fprintf(stderr, "This program was built for coursekit: start it with `ros2 run` or a launch file.\n");
    _Exit(127);
  }
  Connection connection = open_connection(address);
  char first = purpose;
  if (connection == NO_CONNECTION || !send_all(connection, &first, 1)) {
    _Exit(127);
  }
  return connection;
}
void use_connection(Connection connection) {t_connection = connection;}
void begin_thread() {guarded([] {link();});}
void serve_calls() {link().wait();}

Unpacker request(const char * what, const Packer & with)
{
  return guarded([&] {return link().ask(what, with);});
}
void note(const char * what, const Packer & with)
{
  guarded([&] {link().note(what, with);});
}
int64_t add_handler(Handler handler)
{
  std::lock_guard<std::mutex> hold(handlers().lock);
  handlers().by_number[handlers().next] = std::make_shared<Handler>(std::move(handler));
  return handlers().next++;
}
void remove_handler(int64_t number)
{
  std::shared_ptr<Handler> last;  // what it captured is destroyed after the lock is given back
  std::lock_guard<std::mutex> hold(handlers().lock);
  auto found = handlers().by_number.find(number);
  if (found != handlers().by_number.end()) {
    last = found->second;
    handlers().by_number.erase(found);
  }
}
}  // namespace coursekit
