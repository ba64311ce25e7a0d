// Statistics that a program collects itself, with libstatistics_collector's classes and rclcpp's over them.
#include "check.hpp"
#include "libstatistics_collector/collector/metric_details_interface.hpp"
#include "libstatistics_collector/moving_average_statistics/types.hpp"
#include "libstatistics_collector/topic_statistics_collector/received_message_period.hpp"
#include "rclcpp/topic_statistics/subscription_topic_statistics.hpp"
#include "sensor_msgs/msg/detail/imu__type_support.hpp"

using sensor_msgs::msg::Imu;
using statistics_msgs::msg::MetricsMessage;
namespace collectors = libstatistics_collector::topic_statistics_collector;

/// The share of the processor, as a program measures it.
class Share : public libstatistics_collector::collector::Collector
{
public:
  std::string GetMetricName() const override {return "share";}
  std::string GetMetricUnit() const override {return "percent";}

private:
  bool SetupStart() override {return true;}
  bool SetupStop() override {return true;}
};
class Watch : public rclcpp::topic_statistics::SubscriptionTopicStatistics<Imu>
{
public:
  using SubscriptionTopicStatistics::SubscriptionTopicStatistics;
  using SubscriptionTopicStatistics::get_current_collector_data;
};
static Imu stamped(int32_t seconds)
{
  Imu message;
  message.header.stamp.sec = seconds;
  return message;
}
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  Share share;
  check("it starts once", share.Start() && !share.Start() && share.IsStarted());
  share.AcceptData(2);
  share.AcceptData(4);
  equal("its status", share.GetStatusString(), "name=share, unit=percent, started=true, avg=3, min=2, max=4, std_dev=1, count=2");
  check("it stops once", share.Stop() && !share.Stop());
  equal("and forgets", share.GetStatisticsResults().sample_count, 0u);

  collectors::ReceivedMessagePeriodCollector<Imu> period;
  period.Start();
  for (int64_t when : {1000000000, 1500000000}) {
    period.OnMessageReceived(Imu(), when);
  }
  equal("the time between two", period.GetStatisticsResults().average, 500.0);
  check("only some have a header", collectors::HasHeader<Imu>::value && !collectors::HasHeader<MetricsMessage>::value);

  auto node = rclcpp::Node::make_shared("statistics");
  std::vector<MetricsMessage> told;
  auto ear = node->create_subscription<MetricsMessage>("/statistics", 10, [&](const MetricsMessage & m) {told.push_back(m);});
  auto publisher = node->create_publisher<MetricsMessage>(rclcpp::topic_statistics::kDefaultPublishTopicName, 10);
  throws<std::invalid_argument>("a publisher is needed", [] {Watch("nobody", nullptr);});
  Watch watch(node->get_name(), publisher);
  watch.handle_message(stamped(8), rclcpp::Time(10, 0));
  watch.handle_message(stamped(9), rclcpp::Time(12, 0));
  equal("two metrics", watch.get_current_collector_data().size(), 2u);
  watch.publish_message();
  check("a message of each", spin_until(node, [&] {return told.size() == 2;}));
  check("by name", told[0].metrics_source == "message_age" && told[1].metrics_source == "message_period");
  check("of the node, in ms", told[0].measurement_source_name == "statistics" && told[0].unit == "ms");
  equal("the ages' average", told[0].statistics[0].data, 2500.0);
  equal("the periods' count", told[1].statistics[3].data, 1.0);
  equal("it begins anew", watch.get_current_collector_data()[0].sample_count, 0u);
  rclcpp::shutdown();
}
