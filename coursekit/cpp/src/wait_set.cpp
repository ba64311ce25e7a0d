// Wait sets: the session waits in the program's stead.
#include "rclcpp/rclcpp.hpp"
#include "wait.hpp"

namespace rclcpp
{
WaitResultKind WaitSet::wait_ns(int64_t nanoseconds)
{
  gather();
  for (auto & waitable : waitables_) {
    waitable->add_to_wait_set(&state_);
  }
  auto numbers = coursekit::numbers_in(state_);
  if (numbers.empty()) {
    return WaitResultKind::Empty;
  }
  Packer with = Packer{}.i(nanoseconds).i(static_cast<int64_t>(numbers.size()));
  for (int64_t number : numbers) {
    with.i(number);
  }
  Unpacker answer = ask("wait", with);
  std::vector<bool> ready(numbers.size());
  for (size_t i = 0; i < ready.size(); ++i) {
    ready[i] = answer.i();
  }
  coursekit::keep_ready(state_, ready);
  bool any = std::find(ready.begin(), ready.end(), true) != ready.end();
  return any ? WaitResultKind::Ready : WaitResultKind::Timeout;
}
void WaitSet::gather()
{
  state_ = {};
  for (auto & one : subscriptions_) {
    rcl_wait_set_add_subscription(&state_, one.get(), nullptr);
  }
  for (auto & one : guards_) {
    rcl_wait_set_add_guard_condition(&state_, one.get(), nullptr);
  }
  for (auto & one : timers_) {
    rcl_wait_set_add_timer(&state_, one.get(), nullptr);
  }
  for (auto & one : clients_) {
    rcl_wait_set_add_client(&state_, one.get(), nullptr);
  }
  for (auto & one : services_) {
    rcl_wait_set_add_service(&state_, one.get(), nullptr);
  }
}
void WaitSet::forget()
{
  gather();
  coursekit::keep_ready(state_, {});
}
}  // namespace rclcpp
