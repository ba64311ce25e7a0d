// Wait sets: a program waits for subscriptions, timers, guard conditions, clients and services itself, and takes what is there.
#pragma once
#include <array>
#include <chrono>
#include <mutex>
#include <optional>
#include <vector>

#include "rclcpp/client.hpp"
#include "rclcpp/guard_condition.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp/timer.hpp"
#include "rclcpp/waitable.hpp"

namespace rclcpp
{
enum WaitResultKind {Ready, Timeout, Empty};

template<class S>
class WaitResult
{
public:
  WaitResult(WaitResultKind kind, S & set)
  : kind_(kind), set_(&set) {}
  WaitResultKind kind() const {return kind_;}
  const S & get_wait_set() const {return valid();}
  S & get_wait_set() {return valid();}

private:
  S & valid() const
  {
    if (kind_ != WaitResultKind::Ready) {
      throw std::runtime_error("cannot access wait set when the result was not ready");
    }
    return *set_;
  }
  WaitResultKind kind_;
  S * set_;
};

struct SubscriptionWaitSetMask
{
  bool include_subscription = true, include_events = true, include_intra_process_waitable = true;
};

class WaitSet
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(WaitSet)
  struct SubscriptionEntry
  {
    SubscriptionEntry(  // NOLINT: as Humble's, it stands for its subscription
      SubscriptionBase::SharedPtr subscription_ = nullptr, const SubscriptionWaitSetMask & mask_ = {})
    : subscription(std::move(subscription_)), mask(mask_) {}
    SubscriptionBase::SharedPtr subscription;
    SubscriptionWaitSetMask mask;
  };
  struct WaitableEntry
  {
    WaitableEntry(  // NOLINT: as Humble's, it stands for its waitable
      Waitable::SharedPtr waitable_ = nullptr, std::shared_ptr<void> associated_entity_ = nullptr)
    : waitable(std::move(waitable_)), associated_entity(std::move(associated_entity_)) {}
    Waitable::SharedPtr waitable;
    std::shared_ptr<void> associated_entity;
  };
  using Subscriptions = std::vector<SubscriptionEntry>;
  using Guards = std::vector<GuardCondition::SharedPtr>;
  using Timers = std::vector<TimerBase::SharedPtr>;
  using Clients = std::vector<ClientBase::SharedPtr>;
  using Services = std::vector<ServiceBase::SharedPtr>;
  explicit WaitSet(
    const Subscriptions & subscriptions = {}, const Guards & guards = {}, const Timers & timers = {},
    const Clients & clients = {}, const Services & services = {}, const std::vector<WaitableEntry> & waitables = {},
    Context::SharedPtr context = contexts::get_global_default_context());
  ~WaitSet();
  WaitSet(const WaitSet &) = delete;

  /// Wait for a subscription's messages and events, or for what of them a mask says.
  void add_subscription(SubscriptionBase::SharedPtr subscription, SubscriptionWaitSetMask mask = {});
  void remove_subscription(SubscriptionBase::SharedPtr subscription, SubscriptionWaitSetMask mask = {});
  void add_timer(TimerBase::SharedPtr timer);
  void remove_timer(TimerBase::SharedPtr timer);
  void add_client(ClientBase::SharedPtr client);
  void remove_client(ClientBase::SharedPtr client);
  void add_service(ServiceBase::SharedPtr service);
  void remove_service(ServiceBase::SharedPtr service);
  void add_guard_condition(GuardCondition::SharedPtr guard);
  void remove_guard_condition(GuardCondition::SharedPtr guard);
  void add_waitable(Waitable::SharedPtr waitable, std::shared_ptr<void> associated_entity = nullptr);
  void remove_waitable(Waitable::SharedPtr waitable);
  void prune_deleted_entities() {}

  /// Wait until something is ready, at most so long (negative: without end).
  template<class Rep = int64_t, class Period = std::milli>
  WaitResult<WaitSet> wait(std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return {wait_ns(std::chrono::duration_cast<std::chrono::nanoseconds>(timeout).count()), *this};
  }
  const rcl_wait_set_t & get_rcl_wait_set() const {return state_;}

private:
  template<class T>
  void add(std::vector<std::shared_ptr<T>> & all, const std::shared_ptr<T> & one, const char * what);
  template<class T>
  void remove(std::vector<std::shared_ptr<T>> & all, const std::shared_ptr<T> & one, const char * what);
  /// The same of what only one set may have.
  template<class T>
  void add_claimed(std::vector<std::shared_ptr<T>> & all, const std::shared_ptr<T> & one, const char * what);
  template<class T>
  void remove_claimed(std::vector<std::shared_ptr<T>> & all, const std::shared_ptr<T> & one, const char * what);
  WaitResultKind wait_ns(int64_t nanoseconds);
  /// Wait once; what is ready is told by `state_`. Nothing where only another thread has changed the set.
  std::optional<WaitResultKind> wait_once(int64_t nanoseconds);
  /// All that is waited for, but for waitables.
  rcl_wait_set_t gathered() const;
  /// Gather it, and say of all that it is not ready; who waits begins again.
  void forget();

protected:
  /// Let other threads add and remove while one waits.
  void allow_changes();

private:
  /// What another thread raises that adds or removes something; null where none may.
  GuardCondition::SharedPtr changed_;
  std::mutex lock_;
  std::vector<SubscriptionBase::SharedPtr> subscriptions_;
  Guards guards_;
  Timers timers_;
  Clients clients_;
  Services services_;
  std::vector<Waitable::SharedPtr> waitables_;
  rcl_wait_set_t state_;
};

/// A wait set to which other threads may add, and from which they may remove, while one waits.
class ThreadSafeWaitSet : public WaitSet
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ThreadSafeWaitSet)
  explicit ThreadSafeWaitSet(
    const Subscriptions & subscriptions = {}, const Guards & guards = {}, const Timers & timers = {},
    const Clients & clients = {}, const Services & services = {}, const std::vector<WaitableEntry> & waitables = {},
    Context::SharedPtr context = contexts::get_global_default_context())
  : WaitSet(subscriptions, guards, timers, clients, services, waitables, std::move(context))
  {
    allow_changes();
  }
};

/// A wait set whose numbers of entities are fixed.
template<size_t NSubscriptions, size_t NGuards = 0, size_t NTimers = 0, size_t NClients = 0, size_t NServices = 0,
  size_t NWaitables = 0>
class StaticWaitSet : public WaitSet
{
public:
  explicit StaticWaitSet(
    const std::array<SubscriptionEntry, NSubscriptions> & subscriptions = {},
    const std::array<GuardCondition::SharedPtr, NGuards> & guards = {},
    const std::array<TimerBase::SharedPtr, NTimers> & timers = {},
    const std::array<ClientBase::SharedPtr, NClients> & clients = {},
    const std::array<ServiceBase::SharedPtr, NServices> & services = {},
    const std::array<WaitableEntry, NWaitables> & waitables = {},
    Context::SharedPtr context = contexts::get_global_default_context())
  : WaitSet(
      {subscriptions.begin(), subscriptions.end()}, {guards.begin(), guards.end()}, {timers.begin(), timers.end()},
      {clients.begin(), clients.end()}, {services.begin(), services.end()}, {waitables.begin(), waitables.end()},
      std::move(context)) {}

  // Nothing comes to it, and nothing leaves it: a program that tries does not compile, here as on a robot.
  template<class ... T> void add_subscription(T && ...) = delete;
  template<class ... T> void add_guard_condition(T && ...) = delete;
  template<class ... T> void add_timer(T && ...) = delete;
  template<class ... T> void add_client(T && ...) = delete;
  template<class ... T> void add_service(T && ...) = delete;
  template<class ... T> void add_waitable(T && ...) = delete;
  template<class ... T> void remove_subscription(T && ...) = delete;
  template<class ... T> void remove_guard_condition(T && ...) = delete;
  template<class ... T> void remove_timer(T && ...) = delete;
  template<class ... T> void remove_client(T && ...) = delete;
  template<class ... T> void remove_service(T && ...) = delete;
  template<class ... T> void remove_waitable(T && ...) = delete;
};
}  // namespace rclcpp
