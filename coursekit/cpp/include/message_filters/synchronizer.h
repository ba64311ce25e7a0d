// Synchronizer: sets of messages, one of each filter, that belong together by the rules of a policy.
#pragma once
#include <tuple>
#include <utility>

#include "message_filters/simple_filter.h"

namespace message_filters
{
/// A message of any type and its stamp, nanoseconds.
struct Stamped
{
  int64_t time = 0;
  std::shared_ptr<const void> message;
};

/// What the policies have in common: types, callbacks, and how a message of any type becomes one of its own.
template<class ... M>
struct PolicyBase
{
  using Messages = std::tuple<M...>;
  static constexpr size_t COUNT = sizeof...(M);
  using Callback = std::function<void (const std::shared_ptr<const M> & ...)>;
  template<class ... A>
  using SignalOf = Signal<A...>;

  PolicyBase() = default;
  PolicyBase(const PolicyBase &) {}  // a copy of a policy calls nobody: each synchronizer has callbacks of its own

  void signal(const std::vector<Stamped> & set) {signal(set, std::index_sequence_for<M...>());}
  Connection add_callback(Callback callback) {return signal_.add(std::move(callback));}

private:
  template<size_t ... i>
  void signal(const std::vector<Stamped> & set, std::index_sequence<i...>)
  {
    signal_.call(std::static_pointer_cast<const M>(set[i].message)...);
  }
  Signal<std::shared_ptr<const M>...> signal_;
};

template<class Policy>
class Synchronizer : public Policy
{
public:
  using Policy::COUNT;
  Synchronizer() = default;
  explicit Synchronizer(const Policy & policy)
  : Policy(policy) {}
  template<class ... F, class = std::enable_if_t<sizeof...(F) == Policy::COUNT>>
  explicit Synchronizer(F & ... filters) {connectInput(filters ...);}
  template<class ... F, class = std::enable_if_t<sizeof...(F) == Policy::COUNT>>
  Synchronizer(const Policy & policy, F & ... filters)
  : Policy(policy) {connectInput(filters ...);}
  ~Synchronizer()
  {
    for (auto & connection : inputs_) {
      connection.disconnect();
    }
  }
  Synchronizer(const Synchronizer &) = delete;

  template<class ... F>
  void connectInput(F & ... filters)
  {
    for (auto & connection : inputs_) {
      connection.disconnect();
    }
    inputs_.clear();
    connect(std::index_sequence_for<F...>(), filters ...);
  }
  template<class C>
  Connection registerCallback(const C & callback) {return this->add_callback(typename Policy::Callback(callback));}
  template<class C, class T>
  Connection registerCallback(const C & member, T * object)
  {
    return this->add_callback([member, object](const auto & ... messages) {(object->*member)(messages ...);});
  }
  void setName(const std::string & name) {name_ = name;}
  const std::string & getName() {return name_;}
  Policy * getPolicy() {return this;}
  template<int i, class M>
  void add(const std::shared_ptr<M> & message)
  {
    using Kind = std::tuple_element_t<i, typename Policy::Messages>;
    std::shared_ptr<const Kind> one = message;
    this->take(i, {message_traits::TimeStamp<Kind>::value(*one).nanoseconds(), one});
  }

private:
  template<size_t ... i, class ... F>
  void connect(std::index_sequence<i...>, F & ... filters)
  {
    (inputs_.push_back(
      filters.registerCallback(
        [this](const std::shared_ptr<const std::tuple_element_t<i, typename Policy::Messages>> & message) {
          this->template add<static_cast<int>(i)>(message);
        })), ...);
  }
  std::vector<Connection> inputs_;
  std::string name_;
};
}  // namespace message_filters
