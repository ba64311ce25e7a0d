// The last messages, by their stamps.
#pragma once
#include <deque>
#include <vector>

#include "message_filters/simple_filter.h"

namespace message_filters
{
template<class M>
class Cache : public SimpleFilter<M>
{
public:
  using MConstPtr = std::shared_ptr<const M>;
  using EventType = MessageEvent<M const>;
  explicit Cache(unsigned int size = 1) {setCacheSize(size);}
  template<class F>
  explicit Cache(F & from, unsigned int size = 1)
  {
    setCacheSize(size);
    connectInput(from);
  }
  ~Cache() override {connection_.disconnect();}
  template<class F>
  void connectInput(F & from)
  {
    connection_.disconnect();
    connection_ = from.registerCallback(
      std::function<void (const EventType &)>([this](const EventType & event) {add(event);}));
  }
  void setCacheSize(unsigned int size) {size_ = size;}
  void add(const MConstPtr & message) {add(EventType(message));}
  void add(const EventType & event)
  {
    const MConstPtr message = event.getMessage();
    {
      std::lock_guard<std::mutex> hold(lock_);
      while (messages_.size() >= size_) {
        messages_.pop_front();
      }
      auto at = messages_.end();
      while (at != messages_.begin() && stamp(*std::prev(at)) > stamp(message)) {
        --at;
      }
      messages_.insert(at, message);
    }
    this->signalMessage(event);
  }
  /// Those from start to end, both included.
  std::vector<MConstPtr> getInterval(const rclcpp::Time & start, const rclcpp::Time & end) const
  {
    std::lock_guard<std::mutex> hold(lock_);
    std::vector<MConstPtr> found;
    for (auto & one : messages_) {
      if (stamp(one) >= start && stamp(one) <= end) {
        found.push_back(one);
      }
    }
    return found;
  }
  /// The smallest run of messages that covers the time from start to end.
  std::vector<MConstPtr> getSurroundingInterval(const rclcpp::Time & start, const rclcpp::Time & end) const
  {
    std::lock_guard<std::mutex> hold(lock_);
    if (messages_.empty()) {
      return {};
    }
    size_t first = messages_.size() - 1, last = messages_.size() - 1;
    while (first > 0 && stamp(messages_[first]) > start) {
      --first;
    }
    for (last = first; last + 1 < messages_.size() && stamp(messages_[last]) < end; ) {
      ++last;
    }
    return {messages_.begin() + static_cast<int>(first), messages_.begin() + static_cast<int>(last) + 1};
  }
  /// The last one before a time; null where there is none.
  MConstPtr getElemBeforeTime(const rclcpp::Time & time) const
  {
    std::lock_guard<std::mutex> hold(lock_);
    MConstPtr found;
    for (auto & one : messages_) {
      if (stamp(one) >= time) {
        break;
      }
      found = one;
    }
    return found;
  }
  MConstPtr getElemAfterTime(const rclcpp::Time & time) const
  {
    std::lock_guard<std::mutex> hold(lock_);
    for (auto & one : messages_) {
      if (stamp(one) > time) {
        return one;
      }
    }
    return nullptr;
  }
  rclcpp::Time getLatestTime() const
  {
    std::lock_guard<std::mutex> hold(lock_);
    return messages_.empty() ? rclcpp::Time(0, 0, RCL_ROS_TIME) : stamp(messages_.back());
  }
  rclcpp::Time getOldestTime() const
  {
    std::lock_guard<std::mutex> hold(lock_);
    return messages_.empty() ? rclcpp::Time(0, 0, RCL_ROS_TIME) : stamp(messages_.front());
  }

private:
  static rclcpp::Time stamp(const MConstPtr & message) {return message_traits::TimeStamp<M>::value(*message);}
  mutable std::mutex lock_;
  std::deque<MConstPtr> messages_;
  size_t size_ = 1;
  Connection connection_;
};
}  // namespace message_filters
