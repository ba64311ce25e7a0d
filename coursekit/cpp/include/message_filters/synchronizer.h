// Synchronizer: sets of messages, one of each filter, that belong together by the rules of a policy.
#pragma once
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "message_filters/pass_through.h"
#include "message_filters/signal9.h"

namespace message_filters
{
/// What any policy has, also one of a program's own: the types of up to nine messages.
template<class ... M>
struct PolicyBase
{
  using Signal = Signal9<M...>;
  using Messages = typename Signal::Messages;
  using Events = typename Signal::Events;
  using RealTypeCount = std::integral_constant<int, static_cast<int>(Signal::COUNT)>;
};

/// The event of a message of any type and the message's stamp, nanoseconds.
struct Stamped
{
  int64_t time = 0;
  std::shared_ptr<const void> message;
};

/// What the policies here have in common: they are told of stamps, and give sets of events of any type.
template<class Policy, class ... M>
class PolicyOf : public PolicyBase<M...>
{
public:
  using Super = PolicyBase<M...>;
  static constexpr size_t COUNT = sizeof...(M);
  PolicyOf() = default;
  PolicyOf(const PolicyOf &) {}  // a copy of a policy belongs to no synchronizer
  template<class Sync>
  void initParent(Sync * parent)
  {
    emit_ = [parent](const std::vector<Stamped> & set) {parent->signal_all(events(set, std::make_index_sequence<9>()));};
  }
  template<int i>
  void add(const std::tuple_element_t<i, typename Super::Events> & event)
  {
    auto kept = std::make_shared<std::tuple_element_t<i, typename Super::Events>>(event);
    static_cast<Policy *>(this)->take(i, {static_cast<Policy *>(this)->stamp_of(*kept), kept});
  }

protected:
  void signal(const std::vector<Stamped> & set)
  {
    if (emit_) {
      emit_(set);
    }
  }
  /// When a message was measured; a policy that does not look at stamps has 0 instead.
  template<class Message>
  static int64_t stamp_of(const MessageEvent<Message const> & event)
  {
    return message_traits::TimeStamp<Message>::value(*event.getMessage()).nanoseconds();
  }
  template<size_t ... i>
  static typename Super::Events events(const std::vector<Stamped> & set, std::index_sequence<i...>)
  {
    return typename Super::Events(event<i>(set)...);
  }

private:
  friend Policy;
  template<size_t i>
  static std::tuple_element_t<i, typename Super::Events> event(const std::vector<Stamped> & set)
  {
    using Event = std::tuple_element_t<i, typename Super::Events>;
    return i < set.size() && set[i].message ? *std::static_pointer_cast<const Event>(set[i].message) : Event();
  }
  std::function<void (const std::vector<Stamped> &)> emit_;
};

template<class Policy>
class Synchronizer : public Policy
{
public:
  using Messages = typename Policy::Messages;
  using Events = typename Policy::Events;
  using Signal = typename Policy::Signal;
  static constexpr uint8_t MAX_MESSAGES = 9;
  static constexpr size_t FILTERS = static_cast<size_t>(Policy::RealTypeCount::value);
  Synchronizer() {init();}
  explicit Synchronizer(const Policy & policy)
  : Policy(policy) {init();}
  template<class ... F, class = std::enable_if_t<sizeof...(F) == FILTERS>>
  explicit Synchronizer(F & ... filters)
  {
    init();
    connectInput(filters ...);
  }
  template<class ... F, class = std::enable_if_t<sizeof...(F) == FILTERS>>
  Synchronizer(const Policy & policy, F & ... filters)
  : Policy(policy)
  {
    init();
    connectInput(filters ...);
  }
  ~Synchronizer() {disconnectAll();}
  Synchronizer(const Synchronizer &) = delete;
  void init() {Policy::initParent(this);}

  template<class ... F>
  void connectInput(F & ... filters)
  {
    disconnectAll();
    connect(std::index_sequence_for<F...>(), filters ...);
  }
  template<class C>
  Connection registerCallback(const C & callback) {return signal_.addCallback(callback);}
  template<class C, class T>
  Connection registerCallback(const C & member, T * object) {return signal_.addCallback(member, object);}
  void setName(const std::string & name) {name_ = name;}
  const std::string & getName() {return name_;}
  Policy * getPolicy() {return static_cast<Policy *>(this);}
  /// Call back with an event of each message; a policy does so when it has a set.
  template<class ... E>
  void signal(const E & ... events) {signal_.call(events ...);}
  void signal_all(const Events & events) {std::apply([this](const auto & ... one) {signal_.call(one ...);}, events);}
  using Policy::add;
  template<int i>
  void add(const std::shared_ptr<std::tuple_element_t<i, Messages> const> & message)
  {
    Policy::template add<i>(std::tuple_element_t<i, Events>(message));
  }

private:
  void disconnectAll()
  {
    for (auto & connection : inputs_) {
      connection.disconnect();
    }
    inputs_.clear();
  }
  template<size_t ... i, class ... F>
  void connect(std::index_sequence<i...>, F & ... filters) {(inputs_.push_back(input<i>(filters)), ...);}
  template<size_t i, class F>
  Connection input(F & filter)
  {
    using Event = std::tuple_element_t<i, Events>;
    return filter.registerCallback(
      std::function<void (const Event &)>(
        [this](const Event & event) {Policy::template add<static_cast<int>(i)>(event);}));
  }
  std::vector<Connection> inputs_;
  Signal signal_;
  std::string name_;
};
}  // namespace message_filters
