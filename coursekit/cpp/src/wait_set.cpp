// Wait sets: the session waits in the program's stead.
#include "rclcpp/rclcpp.hpp"
#include "wait.hpp"

namespace rclcpp
{
namespace
{
EventHandlers<rcl_subscription_event_type_t> events_of(
  const SubscriptionBase::SharedPtr & subscription, const SubscriptionWaitSetMask & mask)
{
  const bool wanted = subscription && mask.include_events;
  return wanted ? subscription->get_event_handlers() : EventHandlers<rcl_subscription_event_type_t>();
}
/// Mark a thing as one of a set, or as one of none; whether it was one before.
template<class T>
bool mark(const std::shared_ptr<T> & one, bool in_use) {return one->exchange_in_use_by_wait_set_state(in_use);}
bool mark(const SubscriptionBase::SharedPtr & one, bool in_use)
{
  return one->exchange_in_use_by_wait_set_state(one.get(), in_use);
}
template<class T>
void claim(const std::shared_ptr<T> & one, const std::string & what)
{
  if (one && mark(one, true)) {
    const bool subscribed = what.rfind("subscription", 0) == 0;  // of which Humble speaks in words of its own
    throw std::runtime_error(what + (subscribed ? " already associated with a wait set" : " already in use by another wait set"));
  }
}
template<class T>
void release(const std::vector<std::shared_ptr<T>> & all)
{
  for (auto & one : all) {
    mark(one, false);
  }
}
}  // namespace

bool SubscriptionBase::exchange_in_use_by_wait_set_state(void * part, bool in_use)
{
  if (!part) {
    throw std::invalid_argument("pointer_to_subscription_part is unexpectedly nullptr");
  }
  if (part == this) {
    return WaitSetPart::exchange_in_use_by_wait_set_state(in_use);
  }
  for (auto & [kind, handler] : events) {
    if (part == handler.get()) {
      return handler->exchange_in_use_by_wait_set_state(in_use);
    }
  }
  throw std::runtime_error("given pointer_to_subscription_part does not match any part");
}

WaitSet::WaitSet(
  const Subscriptions & subscriptions, const Guards & guards, const Timers & timers, const Clients & clients,
  const Services & services, const std::vector<WaitableEntry> & waitables, Context::SharedPtr context)
{
  if (!context) {
    throw std::invalid_argument("context is nullptr");
  }
  if (!context->is_valid()) {
    throw exceptions::RCLInvalidArgument("failed to create wait set: the given context is not valid");
  }
  for (auto & client : clients) {  // another set may have them too, as in Humble, and timers
    add(clients_, client, "client");
  }
  for (auto & service : services) {
    add(services_, service, "service");
  }
  for (auto & entry : subscriptions) {  // without their events, as in Humble
    add(subscriptions_, entry.subscription, "subscription");
  }
  for (auto & guard : guards) {
    add_guard_condition(guard);
  }
  for (auto & timer : timers) {
    add(timers_, timer, "timer");
  }
  for (auto & entry : waitables) {
    add_waitable(entry.waitable, entry.associated_entity);
  }
}
WaitSet::~WaitSet()
{
  release(subscriptions_);
  release(timers_);
  release(clients_);
  release(services_);
  release(guards_);
  release(waitables_);
}
void WaitSet::allow_changes() {changed_ = std::make_shared<GuardCondition>();}

void WaitSet::add_subscription(SubscriptionBase::SharedPtr subscription, SubscriptionWaitSetMask mask)
{
  if (mask.include_subscription || !subscription) {
    add_claimed(subscriptions_, subscription, "subscription");
  }
  for (auto & [kind, handler] : events_of(subscription, mask)) {
    add_claimed(waitables_, Waitable::SharedPtr(handler), "subscription event");
  }
}
void WaitSet::remove_subscription(SubscriptionBase::SharedPtr subscription, SubscriptionWaitSetMask mask)
{
  if (mask.include_subscription || !subscription) {
    remove_claimed(subscriptions_, subscription, "subscription");
  }
  for (auto & [kind, handler] : events_of(subscription, mask)) {
    if (std::find(waitables_.begin(), waitables_.end(), handler) != waitables_.end()) {
      remove_waitable(handler);
    }
  }
}
void WaitSet::add_timer(TimerBase::SharedPtr timer) {add_claimed(timers_, timer, "timer");}
void WaitSet::remove_timer(TimerBase::SharedPtr timer) {remove_claimed(timers_, timer, "timer");}
void WaitSet::add_client(ClientBase::SharedPtr client) {add_claimed(clients_, client, "client");}
void WaitSet::remove_client(ClientBase::SharedPtr client) {remove_claimed(clients_, client, "client");}
void WaitSet::add_service(ServiceBase::SharedPtr service) {add_claimed(services_, service, "service");}
void WaitSet::remove_service(ServiceBase::SharedPtr service) {remove_claimed(services_, service, "service");}
void WaitSet::add_guard_condition(GuardCondition::SharedPtr guard) {add_claimed(guards_, guard, "guard condition");}
void WaitSet::remove_guard_condition(GuardCondition::SharedPtr guard) {remove_claimed(guards_, guard, "guard condition");}
void WaitSet::add_waitable(Waitable::SharedPtr waitable, std::shared_ptr<void>) {add_claimed(waitables_, waitable, "waitable");}
void WaitSet::remove_waitable(Waitable::SharedPtr waitable) {remove_claimed(waitables_, waitable, "waitable");}
template<class T>
void WaitSet::add_claimed(std::vector<std::shared_ptr<T>> & all, const std::shared_ptr<T> & one, const char * what)
{
  claim(one, what);
  add(all, one, what);
}
template<class T>
void WaitSet::remove_claimed(std::vector<std::shared_ptr<T>> & all, const std::shared_ptr<T> & one, const char * what)
{
  remove(all, one, what);
  mark(one, false);
}
template<class T>
void WaitSet::add(std::vector<std::shared_ptr<T>> & all, const std::shared_ptr<T> & one, const char * what)
{
  if (!one) {
    throw std::invalid_argument(std::string(what) + " is nullptr");
  }
  std::lock_guard<std::mutex> hold(lock_);
  if (std::find(all.begin(), all.end(), one) != all.end()) {
    throw std::runtime_error(std::string(what) + " already associated with a wait set");
  }
  all.push_back(one);
  forget();
}
template<class T>
void WaitSet::remove(std::vector<std::shared_ptr<T>> & all, const std::shared_ptr<T> & one, const char * what)
{
  if (!one) {
    throw std::invalid_argument(std::string(what) + " is nullptr");
  }
  std::lock_guard<std::mutex> hold(lock_);
  auto found = std::find(all.begin(), all.end(), one);
  if (found == all.end()) {
    throw std::runtime_error(std::string(what) + " not in wait set");
  }
  all.erase(found);
  forget();
}

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
