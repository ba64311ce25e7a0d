// Wait sets: the session waits in the program's stead.
#include "rclcpp/rclcpp.hpp"

namespace rclcpp
{
WaitResultKind WaitSet::wait_ns(int64_t nanoseconds)
{
  size_t count = subscriptions_.size() + guards_.size() + timers_.size() + clients_.size() + services_.size();
  if (!count) {
    return WaitResultKind::Empty;
  }
  Packer with = Packer{}.i(nanoseconds).i(static_cast<int64_t>(count));
  auto tell = [&](auto & all) {
      for (auto & one : all) {
        with.i(one->id);
      }
    };
  tell(subscriptions_);
  tell(guards_);
  tell(timers_);
  tell(clients_);
  tell(services_);
  Unpacker answer = ask("wait", with);
  std::vector<bool> ready(count);
  for (size_t i = 0; i < count; ++i) {
    ready[i] = answer.i();
  }
  look(ready);
  bool any = std::find(ready.begin(), ready.end(), true) != ready.end();
  return any ? WaitResultKind::Ready : WaitResultKind::Timeout;
}
void WaitSet::look(const std::vector<bool> & ready)
{
  size_t at = 0;
  auto mark = [&](auto & all, std::vector<const void *> & marks, size_t & size) {
      size = all.size();
      marks.assign(size, nullptr);
      for (size_t i = 0; i < size; ++i, ++at) {
        marks[i] = at < ready.size() && ready[at] ? all[i].get() : nullptr;
      }
    };
  mark(subscriptions_, state_.subscriptions, state_.size_of_subscriptions);
  mark(guards_, state_.guard_conditions, state_.size_of_guard_conditions);
  mark(timers_, state_.timers, state_.size_of_timers);
  mark(clients_, state_.clients, state_.size_of_clients);
  mark(services_, state_.services, state_.size_of_services);
}
}  // namespace rclcpp
