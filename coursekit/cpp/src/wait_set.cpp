// Wait sets: the session waits in the program's stead.
#include "rclcpp/rclcpp.hpp"
#include "wait.hpp"

namespace rclcpp
{
WaitResultKind WaitSet::wait_ns(int64_t nanoseconds)
{
  const int64_t end = nanoseconds < 0 ? -1 : coursekit::steady_now() + nanoseconds;
  for (;;) {
    if (auto kind = wait_once(end < 0 ? -1 : std::max<int64_t>(end - coursekit::steady_now(), 0))) {
      return *kind;
    }
  }
}
std::optional<WaitResultKind> WaitSet::wait_once(int64_t nanoseconds)
{
  rcl_wait_set_t set;
  {
    std::lock_guard<std::mutex> hold(lock_);
    set = gathered();
    for (auto & waitable : waitables_) {
      waitable->add_to_wait_set(&set);
    }
  }
  auto numbers = coursekit::numbers_in(set);
  const size_t count = numbers.size();
  if (changed_) {
    numbers.push_back(changed_->id);
  }
  if (numbers.empty()) {
    return WaitResultKind::Empty;
  }
  Packer with = Packer{}.i(nanoseconds).i(static_cast<int64_t>(numbers.size()));
  for (int64_t number : numbers) {
    with.i(number);
  }
  Unpacker answer = ask("wait", with);
  std::vector<bool> ready(count);
  for (size_t i = 0; i < count; ++i) {
    ready[i] = answer.i();
  }
  const bool any = std::find(ready.begin(), ready.end(), true) != ready.end();
  if (!any && changed_ && answer.i()) {
    return std::nullopt;
  }
  coursekit::keep_ready(set, ready);
  std::lock_guard<std::mutex> hold(lock_);
  state_ = set;
  return any ? WaitResultKind::Ready : WaitResultKind::Timeout;
}
rcl_wait_set_t WaitSet::gathered() const
{
  rcl_wait_set_t set;
  for (auto & one : subscriptions_) {
    rcl_wait_set_add_subscription(&set, one.get(), nullptr);
  }
  for (auto & one : guards_) {
    rcl_wait_set_add_guard_condition(&set, one.get(), nullptr);
  }
  for (auto & one : timers_) {
    rcl_wait_set_add_timer(&set, one.get(), nullptr);
  }
  for (auto & one : clients_) {
    rcl_wait_set_add_client(&set, one.get(), nullptr);
  }
  for (auto & one : services_) {
    rcl_wait_set_add_service(&set, one.get(), nullptr);
  }
  return set;
}
void WaitSet::forget()
{
  state_ = gathered();
  coursekit::keep_ready(state_, {});
  if (changed_) {
    changed_->trigger();
  }
}
}  // namespace rclcpp
