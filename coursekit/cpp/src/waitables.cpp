// Waitables of the program: the session waits for what they add to a wait set, and has them executed.
#include <algorithm>

#include "rclcpp/guard_condition.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/waitable.hpp"
#include "wait.hpp"

namespace coursekit
{
namespace
{
using Entities = std::vector<const Entity *>;

/// Visit the six kinds in the order in which the link has them.
template<class Visit>
void each_kind(rcl_wait_set_t & set, Visit visit)
{
  for (Entities * all : {&set.subscriptions, &set.guard_conditions, &set.timers, &set.clients, &set.services, &set.events}) {
    visit(*all);
  }
}
}  // namespace

std::vector<int64_t> numbers_in(rcl_wait_set_t & set)
{
  std::vector<int64_t> all;
  each_kind(set, [&](Entities & kind) {
      for (auto one : kind) {
        all.push_back(one->id);
      }
    });
  return all;
}
void keep_ready(rcl_wait_set_t & set, const std::vector<bool> & ready)
{
  size_t at = 0;
  each_kind(set, [&](Entities & kind) {
      for (auto & one : kind) {
        one = at < ready.size() && ready[at] ? one : nullptr;
        ++at;
      }
    });
}
}  // namespace coursekit

namespace rclcpp
{
namespace
{
/// A waitable that a node's executor serves, and what it waited for last.
class Served : public coursekit::Entity
{
public:
  explicit Served(const std::shared_ptr<Waitable> & waitable)
  : waitable_(waitable) {}
  /// Ask the waitable what to wait for, and tell the session.
  void wait_again(Packer & to)
  {
    rcl_wait_set_t set;
    if (auto waitable = waitable_.lock()) {
      waitable->add_to_wait_set(&set);
    }
    auto numbers = coursekit::numbers_in(set);
    {
      std::lock_guard<std::mutex> hold(lock_);
      set_ = set;
      numbers_ = numbers;
    }
    to.i(static_cast<int64_t>(numbers.size()));
    for (int64_t number : numbers) {
      to.i(number);
    }
  }
  /// Execute it if it is ready, by the numbers of what is; whether it was.
  bool execute(const std::vector<int64_t> & numbers)
  {
    rcl_wait_set_t set;
    std::vector<bool> ready;
    {
      std::lock_guard<std::mutex> hold(lock_);
      set = set_;
      for (int64_t number : numbers_) {
        ready.push_back(std::find(numbers.begin(), numbers.end(), number) != numbers.end());
      }
    }
    coursekit::keep_ready(set, ready);
    auto waitable = waitable_.lock();
    if (!waitable || !waitable->is_ready(&set)) {
      return false;
    }
    auto data = waitable->take_data();
    waitable->execute(data);
    return true;
  }

private:
  std::weak_ptr<Waitable> waitable_;
  std::mutex lock_;
  rcl_wait_set_t set_;
  std::vector<int64_t> numbers_;
};
}  // namespace

namespace node_interfaces
{
void NodeBaseInterface::add_waitable(std::shared_ptr<Waitable> waitable, CallbackGroup::SharedPtr in)
{
  if (in && !callback_group_in_node(in)) {
    throw std::runtime_error("Cannot create waitable, group not in node.");
  }
  auto served = std::make_shared<Served>(waitable);
  std::weak_ptr<Served> weak = served;
  int64_t handler = served->handle(
    [weak](Unpacker & from, Packer & to) {
      std::vector<int64_t> ready(static_cast<size_t>(from.i()));
      for (auto & number : ready) {
        number = from.i();
      }
      auto me = weak.lock();
      to.i(me && me->execute(ready));
      me ? me->wait_again(to) : static_cast<void>(to.i(0));
    });
  Packer with = Packer{}.i(id).i(in ? in->id : 0).i(handler);
  served->wait_again(with);
  served->id = ask("waitable", with).i();
  (in ? in : group)->enlist(waitable);
  std::lock_guard<std::mutex> hold(lock_);
  waitables_[waitable.get()] = served;
}
void NodeBaseInterface::remove_waitable(std::shared_ptr<Waitable> waitable, CallbackGroup::SharedPtr) noexcept
{
  std::shared_ptr<coursekit::Entity> last;  // the session is told after the lock is given back
  std::lock_guard<std::mutex> hold(lock_);
  auto found = waitables_.find(waitable.get());
  if (found != waitables_.end()) {
    last = found->second;
    waitables_.erase(found);
  }
}
}  // namespace node_interfaces

void GuardCondition::add_to_wait_set(rcl_wait_set_t * wait_set)
{
  std::lock_guard<std::recursive_mutex> hold(lock_);
  if (exchange_in_use_by_wait_set_state(true) && !in_waitable_) {
    throw std::runtime_error("guard condition has already been added to a wait set.");
  }
  in_waitable_ = true;
  rcl_wait_set_add_guard_condition(wait_set, this, nullptr);
}
}  // namespace rclcpp
