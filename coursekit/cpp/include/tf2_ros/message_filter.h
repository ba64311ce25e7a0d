// Messages that wait until they can be transformed.
#pragma once
#include <deque>

#include "message_filters/simple_filter.h"
#include "tf2_ros/buffer.h"
#include "tf2_ros/create_timer_ros.h"

namespace tf2_ros
{
namespace filter_failure_reasons
{
enum FilterFailureReason {Unknown, OutTheBack, EmptyFrameID, NoTransformFound, QueueFull, FilterFailureReasonCount};
}  // namespace filter_failure_reasons
using FilterFailureReason = filter_failure_reasons::FilterFailureReason;

inline std::string get_filter_failure_reason_string(FilterFailureReason reason)
{
  switch (reason) {
    case filter_failure_reasons::OutTheBack:
      return "the timestamp on the message is earlier than all the data in the transform cache";
    case filter_failure_reasons::EmptyFrameID:
      return "the frame id of the message is empty";
    case filter_failure_reasons::NoTransformFound:
      return "did not find a valid transform, this usually happens at startup ...";
    case filter_failure_reasons::QueueFull:
      return "discarding message because the queue is full";
    case filter_failure_reasons::Unknown:
      return "Unknown";
    default:
      return "Invalid Failure Reason";
  }
}

class MessageFilterBase
{
public:
  virtual ~MessageFilterBase() = default;
  virtual void clear() = 0;
  virtual void setTargetFrame(const std::string & target) = 0;
  virtual void setTargetFrames(const std::vector<std::string> & targets) = 0;
  virtual void setTolerance(const rclcpp::Duration & tolerance) = 0;
};

/// Passes a message on when there is a transform from its frame to each target frame, at its time.
template<class M, class B = tf2_ros::Buffer>
class MessageFilter : public MessageFilterBase, public message_filters::SimpleFilter<M>
{
public:
  using MConstPtr = std::shared_ptr<const M>;
  using MEvent = message_filters::MessageEvent<M const>;
  using FailureCallback = std::function<void (const MConstPtr &, FilterFailureReason)>;

  template<class Rep = int64_t, class Period = std::nano>
  MessageFilter(
    B & buffer, const std::string & target, uint32_t queue_size, const rclcpp::Node::SharedPtr & node,
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>::max())
  : MessageFilter(buffer, target, queue_size, node->get_node_logging_interface(), node->get_node_clock_interface(), timeout) {}
  template<class Rep = int64_t, class Period = std::nano>
  MessageFilter(
    B & buffer, const std::string & target, uint32_t queue_size, rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr logging,
    rclcpp::node_interfaces::NodeClockInterface::SharedPtr,
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>::max())
  : buffer_(buffer), queue_size_(queue_size), node_(logging), timeout_ns_(in_nanoseconds(timeout))
  {
    setTargetFrame(target);
    auto look_often = std::chrono::milliseconds(10);
    timer_ = rclcpp::detail::timer(*node_, look_often, [this] {look();}, nullptr, nullptr);
    timer_->cancel();
  }
  template<class F, class Rep = int64_t, class Period = std::nano>
  MessageFilter(
    F & from, B & buffer, const std::string & target, uint32_t queue_size, const rclcpp::Node::SharedPtr & node,
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>::max())
  : MessageFilter(buffer, target, queue_size, node, timeout) {connectInput(from);}
  template<class F, class Rep = int64_t, class Period = std::nano>
  MessageFilter(
    F & from, B & buffer, const std::string & target, uint32_t queue_size,
    rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr logging,
    rclcpp::node_interfaces::NodeClockInterface::SharedPtr clock,
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>::max())
  : MessageFilter(buffer, target, queue_size, logging, clock, timeout) {connectInput(from);}
  ~MessageFilter() override {connection_.disconnect();}

  template<class F>
  void connectInput(F & from)
  {
    connection_.disconnect();
    connection_ = from.registerCallback([this](const MConstPtr & message) {add(message);});
  }
  void setTargetFrame(const std::string & target) override {setTargetFrames({target});}
  void setTargetFrames(const std::vector<std::string> & targets) override
  {
    std::lock_guard<std::mutex> hold(lock_);
    targets_.clear();
    for (auto & target : targets) {
      targets_.push_back(target.empty() || target.front() != '/' ? target : target.substr(1));
    }
  }
  std::string getTargetFramesString()
  {
    std::lock_guard<std::mutex> hold(lock_);
    std::string all;
    for (auto & target : targets_) {
      all += (all.empty() ? "" : " ") + target;
    }
    return all;
  }
  void setTolerance(const rclcpp::Duration & tolerance) override {tolerance_ns_ = tolerance.nanoseconds();}
  void setQueueSize(uint32_t size) {queue_size_ = size;}
  uint32_t getQueueSize() {return queue_size_;}
  void registerFailureCallback(FailureCallback callback) {failed_ = std::move(callback);}
  void clear() override
  {
    std::lock_guard<std::mutex> hold(lock_);
    waiting_.clear();
  }
  void add(const MEvent & event) {add(event.getMessage());}
  void add(const MConstPtr & message)
  {
    if (Frame::value(*message).empty()) {
      fail(message, filter_failure_reasons::EmptyFrameID);
      return;
    }
    if (ready(message)) {
      this->signalMessage(message);
      return;
    }
    MConstPtr oldest;
    {
      std::lock_guard<std::mutex> hold(lock_);
      if (queue_size_ && waiting_.size() >= queue_size_) {
        oldest = waiting_.front().message;
        waiting_.pop_front();
      }
      waiting_.push_back({message, coursekit::steady_now()});
    }
    if (oldest) {
      fail(oldest, filter_failure_reasons::QueueFull);
    }
    timer_->reset();
  }

private:
  using Frame = message_filters::message_traits::FrameId<M>;
  static tf2::TimePoint stamp_of(const M & message)
  {
    return fromRclcpp(message_filters::message_traits::TimeStamp<M>::value(message));
  }
  struct Waiting
  {
    MConstPtr message;
    int64_t since;
  };
  template<class Rep, class Period>
  static int64_t in_nanoseconds(std::chrono::duration<Rep, Period> timeout)
  {
    if (timeout == std::chrono::duration<Rep, Period>::max()) {
      return std::numeric_limits<int64_t>::max();
    }
    return std::chrono::duration_cast<std::chrono::nanoseconds>(timeout).count();
  }
  bool ready(const MConstPtr & message)
  {
    std::vector<std::string> targets;
    {
      std::lock_guard<std::mutex> hold(lock_);
      targets = targets_;
    }
    auto stamp = stamp_of(*message);
    for (auto & target : targets) {
      auto can = [&](tf2::TimePoint when) {return buffer_.canTransform(target, Frame::value(*message), when);};
      if (!can(stamp) || (tolerance_ns_ && !can(stamp + std::chrono::nanoseconds(tolerance_ns_)))) {
        return false;
      }
    }
    return !targets.empty();
  }
  void look()
  {
    std::deque<Waiting> now, still;
    {
      std::lock_guard<std::mutex> hold(lock_);
      now.swap(waiting_);
    }
    for (auto & one : now) {
      if (ready(one.message)) {
        this->signalMessage(one.message);
      } else if (coursekit::steady_now() - one.since > timeout_ns_) {
        fail(one.message, filter_failure_reasons::NoTransformFound);
      } else {
        still.push_back(one);
      }
    }
    std::lock_guard<std::mutex> hold(lock_);
    waiting_.insert(waiting_.begin(), still.begin(), still.end());
    if (waiting_.empty()) {
      timer_->cancel();
    }
  }
  void fail(const MConstPtr & message, FilterFailureReason reason)
  {
    RCLCPP_INFO(
      node_->get_logger(), "Message Filter dropping message: frame '%s' at time %.3f for reason '%s'",
      Frame::value(*message).c_str(), tf2::timeToSec(stamp_of(*message)),
      get_filter_failure_reason_string(reason).c_str());
    if (failed_) {
      failed_(message, reason);
    }
  }

  B & buffer_;
  uint32_t queue_size_;
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_;
  int64_t timeout_ns_, tolerance_ns_ = 0;
  std::mutex lock_;
  std::vector<std::string> targets_;
  std::deque<Waiting> waiting_;
  FailureCallback failed_;
  rclcpp::TimerBase::SharedPtr timer_;
  message_filters::Connection connection_;
};
}  // namespace tf2_ros
