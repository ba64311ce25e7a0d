// Messages in the order of their stamps: each is held back until it is old enough for none before it to come any more.
#pragma once
#include <set>
#include <vector>

#include "message_filters/simple_filter.h"

namespace message_filters
{
template<class M>
class TimeSequencer : public SimpleFilter<M>
{
public:
  using MConstPtr = std::shared_ptr<const M>;
  using EventType = MessageEvent<M const>;
  /// Messages wait for `delay`; each `update_rate` it is looked which have. `queue_size` 0 keeps any number.
  TimeSequencer(rclcpp::Duration delay, rclcpp::Duration update_rate, uint32_t queue_size, rclcpp::Node::SharedPtr node)
  : delay_(delay), queue_size_(queue_size), node_(node)
  {
    timer_ = node->create_wall_timer(std::chrono::nanoseconds(update_rate.nanoseconds()), [this] {pass_on();});
  }
  template<class F>
  TimeSequencer(
    F & from, rclcpp::Duration delay, rclcpp::Duration update_rate, uint32_t queue_size, rclcpp::Node::SharedPtr node)
  : TimeSequencer(delay, update_rate, queue_size, node) {connectInput(from);}
  ~TimeSequencer() override
  {
    timer_->cancel();
    incoming_.disconnect();
  }
  template<class F>
  void connectInput(F & from)
  {
    incoming_.disconnect();
    incoming_ = from.registerCallback(
      std::function<void (const EventType &)>([this](const EventType & event) {add(event);}));
  }
  void add(const MConstPtr & message) {add(EventType(message));}
  /// One from before what was passed on already is thrown away.
  void add(const EventType & event)
  {
    std::lock_guard<std::mutex> hold(lock_);
    if (stamp(event) < last_) {
      return;
    }
    waiting_.insert(event);
    if (queue_size_ && waiting_.size() > queue_size_) {
      waiting_.erase(waiting_.begin());
    }
  }

private:
  /// Nanoseconds: programs stamp by clocks of several types.
  static int64_t stamp(const EventType & event) {return message_traits::TimeStamp<M>::value(*event.getMessage()).nanoseconds();}
  struct Earlier
  {
    bool operator()(const EventType & a, const EventType & b) const {return stamp(a) < stamp(b);}
  };
  void pass_on()
  {
    std::vector<EventType> due;
    {
      std::lock_guard<std::mutex> hold(lock_);
      const int64_t now = rclcpp::Clock().now().nanoseconds();
      while (!waiting_.empty() && stamp(*waiting_.begin()) + delay_.nanoseconds() <= now) {
        last_ = stamp(*waiting_.begin());
        due.push_back(*waiting_.begin());
        waiting_.erase(waiting_.begin());
      }
    }
    for (auto & event : due) {
      this->signalMessage(event);
    }
  }

  rclcpp::Duration delay_;
  uint32_t queue_size_;
  rclcpp::Node::SharedPtr node_;
  rclcpp::TimerBase::SharedPtr timer_;
  Connection incoming_;
  std::mutex lock_;
  std::multiset<EventType, Earlier> waiting_;
  int64_t last_ = 0;
};
}  // namespace message_filters
