// Which callbacks may run beside each other.
#pragma once
#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <tuple>
#include <vector>

#include "coursekit/entity.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{
class ClientBase;
class ServiceBase;
class SubscriptionBase;
class TimerBase;
class Waitable;

enum class CallbackGroupType {MutuallyExclusive, Reentrant};

class CallbackGroup : public coursekit::Entity
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(CallbackGroup)
  CallbackGroup(int64_t number, CallbackGroupType type, bool automatic = true)
  : type_(type), automatic_(automatic) {id = number;}
  const CallbackGroupType & type() const {return type_;}
  bool automatically_add_to_executor_with_node() const {return automatic_;}
  /// Whether an executor may take a callback of the group now: the session's does, whatever a program writes here.
  std::atomic_bool & can_be_taken_from() {return can_be_taken_from_;}

  // -- what is in it; the first for which a function holds, nullptr where it holds for none

  template<class F>
  std::shared_ptr<SubscriptionBase> find_subscription_ptrs_if(F holds) const {return find<SubscriptionBase>(holds);}
  template<class F>
  std::shared_ptr<TimerBase> find_timer_ptrs_if(F holds) const {return find<TimerBase>(holds);}
  template<class F>
  std::shared_ptr<ServiceBase> find_service_ptrs_if(F holds) const {return find<ServiceBase>(holds);}
  template<class F>
  std::shared_ptr<ClientBase> find_client_ptrs_if(F holds) const {return find<ClientBase>(holds);}
  template<class F>
  std::shared_ptr<Waitable> find_waitable_ptrs_if(F holds) const {return find<Waitable>(holds);}
  template<class S, class V, class C, class T, class W>
  void collect_all_ptrs(const S & subscription, const V & service, const C & client, const T & timer, const W & waitable) const
  {
    auto all = [](const auto & take) {return [&take](const auto & one) {take(one); return false;};};
    find<SubscriptionBase>(all(subscription));
    find<ServiceBase>(all(service));
    find<ClientBase>(all(client));
    find<TimerBase>(all(timer));
    find<Waitable>(all(waitable));
  }
  /// Take in what a node has made in this group.
  template<class E>
  void enlist(const std::shared_ptr<E> & made)
  {
    std::lock_guard<std::mutex> hold(lock_);
    auto & list = std::get<List<E>>(members_);
    list.erase(std::remove_if(list.begin(), list.end(), [](auto & one) {return one.expired();}), list.end());
    list.push_back(made);
  }

  /// Whether an executor serves it by itself, apart from its node.
  std::atomic<bool> & get_associated_with_executor_atomic() {return in_executor_;}

private:
  template<class E>
  using List = std::vector<std::weak_ptr<E>>;
  template<class E, class F>
  std::shared_ptr<E> find(const F & holds) const
  {
    List<E> list;
    {
      std::lock_guard<std::mutex> hold(lock_);
      list = std::get<List<E>>(members_);
    }
    for (auto & weak : list) {
      auto one = weak.lock();
      if (one && holds(one)) {
        return one;
      }
    }
    return nullptr;
  }

  CallbackGroupType type_;
  bool automatic_;
  std::atomic<bool> in_executor_{false};
  std::atomic_bool can_be_taken_from_{true};
  mutable std::mutex lock_;
  std::tuple<List<SubscriptionBase>, List<TimerBase>, List<ServiceBase>, List<ClientBase>, List<Waitable>> members_;
};
}  // namespace rclcpp
