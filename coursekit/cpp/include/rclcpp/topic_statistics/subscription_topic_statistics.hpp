// Statistics of a subscription's messages that a program collects and publishes itself.
#pragma once
#include <chrono>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "libstatistics_collector/collector/generate_statistics_message.hpp"
#include "libstatistics_collector/topic_statistics_collector/topic_statistics_collector.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/time.hpp"
#include "rclcpp/timer.hpp"

namespace rclcpp::topic_statistics
{
constexpr const char kDefaultPublishTopicName[]{"/statistics"};
constexpr const std::chrono::milliseconds kDefaultPublishingPeriod{std::chrono::seconds(1)};
using libstatistics_collector::collector::GenerateStatisticMessage;
using libstatistics_collector::moving_average_statistics::StatisticData;
using statistics_msgs::msg::MetricsMessage;

template<typename CallbackMessageT>
class SubscriptionTopicStatistics
{
public:
  SubscriptionTopicStatistics(const std::string & node_name, Publisher<MetricsMessage>::SharedPtr publisher)
  : node_name_(node_name), publisher_(std::move(publisher)), start_(now())
  {
    if (!publisher_) {
      throw std::invalid_argument("publisher pointer is nullptr");
    }
    namespace collectors = libstatistics_collector::topic_statistics_collector;
    collectors_.push_back(std::make_unique<collectors::ReceivedMessageAgeCollector<CallbackMessageT>>());
    collectors_.push_back(std::make_unique<collectors::ReceivedMessagePeriodCollector<CallbackMessageT>>());
    for (auto & one : collectors_) {
      one->Start();
    }
  }
  virtual ~SubscriptionTopicStatistics()
  {
    if (timer_) {
      timer_->cancel();
    }
  }
  virtual void handle_message(const CallbackMessageT & received_message, const rclcpp::Time now_nanoseconds) const
  {
    std::lock_guard<std::mutex> hold(lock_);
    for (auto & one : collectors_) {
      one->OnMessageReceived(received_message, now_nanoseconds.nanoseconds());
    }
  }
  void set_publisher_timer(TimerBase::SharedPtr publisher_timer) {timer_ = std::move(publisher_timer);}
  /// Publish a message for each metric, and begin anew.
  virtual void publish_message()
  {
    const rclcpp::Time end = now();
    std::vector<MetricsMessage> messages;
    {
      std::lock_guard<std::mutex> hold(lock_);
      for (auto & one : collectors_) {
        messages.push_back(
          GenerateStatisticMessage(
            node_name_, one->GetMetricName(), one->GetMetricUnit(), start_, end, one->GetStatisticsResults()));
        one->ClearCurrentMeasurements();
      }
    }
    for (const MetricsMessage & message : messages) {
      publisher_->publish(message);
    }
    start_ = end;
  }

protected:
  std::vector<StatisticData> get_current_collector_data() const
  {
    std::lock_guard<std::mutex> hold(lock_);
    std::vector<StatisticData> data;
    for (auto & one : collectors_) {
      data.push_back(one->GetStatisticsResults());
    }
    return data;
  }

private:
  static rclcpp::Time now() {return rclcpp::Clock(RCL_SYSTEM_TIME).now();}
  using Collector = libstatistics_collector::topic_statistics_collector::TopicStatisticsCollector<CallbackMessageT>;
  mutable std::mutex lock_;
  std::vector<std::unique_ptr<Collector>> collectors_;
  const std::string node_name_;
  Publisher<MetricsMessage>::SharedPtr publisher_;
  TimerBase::SharedPtr timer_;
  rclcpp::Time start_;
};
}  // namespace rclcpp::topic_statistics
