// What collects the age of received messages, and the time between two of them.
#pragma once
#include <type_traits>

#include "libstatistics_collector/collector/collector.hpp"
#include "rcl/time.h"
#include "std_msgs/msg/header.hpp"

namespace libstatistics_collector::topic_statistics_collector
{
namespace topic_statistics_constants
{
constexpr const char kMsgAgeStatName[] = "message_age";
constexpr const char kMsgPeriodStatName[] = "message_period";
constexpr const char kMillisecondUnitName[] = "ms";
}  // namespace topic_statistics_constants
constexpr const int64_t kUninitializedTime{0};
constexpr double kNanosecondsPerMillisecond = 1e6;

template<typename T>
class TopicStatisticsCollector : public collector::Collector
{
public:
  virtual void OnMessageReceived(const T & received_message, const rcl_time_point_value_t now_nanoseconds) = 0;
  std::string GetMetricUnit() const override {return topic_statistics_constants::kMillisecondUnitName;}

private:
  bool SetupStart() override {return true;}
  bool SetupStop() override {return true;}
};

/// Whether a message has a header.
template<typename M, typename = void>
struct HasHeader : public std::false_type {};
template<typename M>
struct HasHeader<M, std::enable_if_t<std::is_same<std_msgs::msg::Header, decltype(M::header)>::value>> : public std::true_type {};

/// The age of messages by the stamps in their headers.
template<typename T>
class ReceivedMessageAgeCollector : public TopicStatisticsCollector<T>
{
public:
  void OnMessageReceived(const T & received_message, const rcl_time_point_value_t now_nanoseconds) override
  {
    if constexpr (HasHeader<T>::value) {
      const auto & stamp = received_message.header.stamp;
      const int64_t sent = stamp.sec * int64_t{1000000000} + stamp.nanosec;
      if (sent && now_nanoseconds) {
        this->AcceptData(static_cast<double>(now_nanoseconds - sent) / kNanosecondsPerMillisecond);
      }
    }
  }
  std::string GetMetricName() const override {return topic_statistics_constants::kMsgAgeStatName;}
};

/// The time between a message and the next.
template<typename T>
class ReceivedMessagePeriodCollector : public TopicStatisticsCollector<T>
{
public:
  void OnMessageReceived(const T &, const rcl_time_point_value_t now_nanoseconds) override
  {
    std::lock_guard<std::mutex> hold(lock_);
    if (last_ != kUninitializedTime) {
      this->AcceptData(static_cast<double>(now_nanoseconds - last_) / kNanosecondsPerMillisecond);
    }
    last_ = now_nanoseconds;
  }
  std::string GetMetricName() const override {return topic_statistics_constants::kMsgPeriodStatName;}

private:
  bool SetupStart() override
  {
    last_ = kUninitializedTime;
    return true;
  }
  std::mutex lock_;
  rcl_time_point_value_t last_ = kUninitializedTime;
};
}  // namespace libstatistics_collector::topic_statistics_collector
