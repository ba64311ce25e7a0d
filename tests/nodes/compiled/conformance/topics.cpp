#include "check.hpp"
#include "rclcpp/wait_for_message.hpp"
#include "sensor_msgs/msg/image.hpp"
#include "statistics_msgs/msg/metrics_message.hpp"
#include "std_msgs/msg/int32.hpp"
#include "std_msgs/msg/string.hpp"

using std_msgs::msg::Int32;
using statistics_msgs::msg::MetricsMessage;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("topics");
  std::vector<int> heard;
  auto keep = [&](const Int32 & message) {heard.push_back(message.data);};
  auto subscription = node->create_subscription<Int32>("number", 3, keep);
  auto publisher = node->create_publisher<Int32>("number", 10);
  for (int i = 0; i < 5; ++i) {
    publisher->publish(Int32().set__data(i));
  }
  spin_until(node, [&] {return heard.size() >= 3;});
  rclcpp::spin_some(node);
  check("the last three are kept", heard == std::vector<int>({2, 3, 4}));
  heard.clear();
  publisher->publish(std::make_unique<Int32>(Int32().set__data(7)));
  auto loan = publisher->borrow_loaned_message();
  check("a loan is valid", loan.is_valid());
  loan.get().data = 8;
  publisher->publish(std::move(loan));
  check("a loan that is gone is not", !loan.is_valid());
  throws<std::runtime_error>("nor published", [&] {publisher->publish(std::move(loan));});
  rclcpp::LoanedMessage<Int32> by_hand(*publisher, std::allocator<Int32>());
  rclcpp::LoanedMessage<Int32> by_its_allocator(*publisher, publisher->get_allocator());
  std::unique_ptr<Int32, std::function<void (Int32 *)>> released = by_its_allocator.release();
  check("loans by hand", by_hand.is_valid() && !by_its_allocator.is_valid() && released);
  rclcpp::PublisherOptions staying;
  staying.use_intra_process_comm = rclcpp::IntraProcessSetting::Enable;
  throws<std::runtime_error>(
    "bytes do not stay in the program", [&] {node->create_publisher<Int32>("kept", 1, staying)->publish(rclcpp::SerializedMessage());});
  rclcpp::Serialization<Int32> serialization;
  Int32 nine;
  nine.data = 9;
  rclcpp::SerializedMessage bytes;
  serialization.serialize_message(&nine, &bytes);
  equal("CDR has four bytes before the number", bytes.size(), 8u);
  publisher->publish(bytes);
  spin_until(node, [&] {return heard.size() >= 3;});
  check("unique, loaned and serialized arrive", heard == std::vector<int>({7, 8, 9}));

  // generic ones
  std::vector<size_t> sizes;
  auto generic = node->create_generic_subscription(
    "number", "std_msgs/msg/Int32", 10, [&](std::shared_ptr<rclcpp::SerializedMessage> m) {sizes.push_back(m->size());});
  auto sender = node->create_generic_publisher("number", "std_msgs/msg/Int32", 10);
  heard.clear();
  sender->publish(bytes);
  spin_until(node, [&] {return heard.size() == 1 && sizes.size() == 1;});
  check("a generic publisher is heard", heard == std::vector<int>({9}));
  check("a generic subscription hears bytes", sizes == std::vector<size_t>({8}));
  check("an unknown type is refused", [&] {
      try {
        node->create_generic_publisher("x", "no_such_msgs/msg/Thing", 1);
      } catch (const std::exception &) {
        return true;
      }
      return false;
    }());
  generic.reset();

  // late hearers
  auto latched = node->create_publisher<Int32>("latched", rclcpp::QoS(1).transient_local());
  latched->publish(Int32().set__data(5));
  Int32 late;
  auto early = node->create_subscription<Int32>(
    "latched", rclcpp::QoS(1).transient_local(), [&](const Int32 & m) {late = m;});
  spin_until(node, [&] {return late.data == 5;});
  equal("a late subscription hears what is latched", late.data, 5);

  // content filters
  heard.clear();
  rclcpp::SubscriptionOptions options;
  options.content_filter_options.filter_expression = "data > %0 AND data < 20";
  options.content_filter_options.expression_parameters = {"10"};
  auto filtered = node->create_subscription<Int32>("filtered", 10, keep, options);
  check("a filter is on", filtered->is_cft_enabled());
  check("no filter is off", !subscription->is_cft_enabled());
  auto to_filter = node->create_publisher<Int32>("filtered", 10);
  for (int i : {5, 15, 25, 16}) {
    to_filter->publish(Int32().set__data(i));
  }
  spin_until(node, [&] {return heard.size() == 2;});
  check("only what passes is heard", heard == std::vector<int>({15, 16}));
  filtered->set_content_filter("data = 25");
  equal("the filter is told", filtered->get_content_filter().filter_expression, "data = 25");
  to_filter->publish(Int32().set__data(15));
  to_filter->publish(Int32().set__data(25));
  spin_until(node, [&] {return heard.size() == 3;});
  equal("the new filter holds", heard.back(), 25);
  int words = 0;
  options.content_filter_options.filter_expression = "data MATCH 'go+d' OR data NOT MATCH %0";
  options.content_filter_options.expression_parameters = {"'.*d'"};
  auto matching = node->create_subscription<std_msgs::msg::String>(
    "word", 10, [&](const std_msgs::msg::String &) {++words;}, options);
  auto speaker = node->create_publisher<std_msgs::msg::String>("word", 10);
  for (auto word : {"bad", "goood", "fine"}) {
    speaker->publish(std_msgs::msg::String().set__data(word));
  }
  spin_until(node, [&] {return words == 2;});
  equal("a filter by regular expressions", words, 2);
  throws<rclcpp::exceptions::RCLError>("a bad filter", [&] {filtered->set_content_filter("data >> 3");});

  // statistics
  rclcpp::SubscriptionOptions counted;
  counted.topic_stats_options.state = rclcpp::TopicStatisticsState::Enable;
  counted.topic_stats_options.publish_period = 200ms;
  counted.topic_stats_options.publish_topic = "/numbers_of_number";
  auto with_statistics = node->create_subscription<Int32>("number", 10, keep, counted);
  std::map<std::string, MetricsMessage> metrics;
  auto hear = [&](const MetricsMessage & m) {metrics.emplace(m.metrics_source, m);};
  auto statistics = node->create_subscription<MetricsMessage>("/numbers_of_number", 10, hear);
  publisher->publish(nine);
  publisher->publish(nine);
  spin_until(node, [&] {return metrics.size() == 2;});
  equal("statistics come from the node", metrics["message_period"].measurement_source_name, "topics");
  equal("in milliseconds", metrics["message_age"].unit, "ms");
  equal("five numbers each", metrics["message_period"].statistics.size(), 5u);
  equal("one period lies between two messages", metrics["message_period"].statistics.at(3).data, 1.0);
  check("no age without a header", std::isnan(metrics["message_age"].statistics.at(0).data));

  // what they know of themselves
  equal("topic's name", std::string(publisher->get_topic_name()), "/number");
  equal("queue's size", publisher->get_queue_size(), 10u);
  check("everybody has acknowledged", publisher->wait_for_all_acked(100ms));
  check("no packets flow from a publisher", publisher->get_network_flow_endpoints().empty());
  check("nor to a subscription", subscription->get_network_flow_endpoints().empty());
  rclcpp::PublisherOptions strict;
  strict.require_unique_network_flow_endpoints = RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_STRICTLY_REQUIRED;
  std::string refused;
  try {
    node->create_publisher<Int32>("number", 3, strict);
  } catch (const rclcpp::exceptions::RCLError & error) {
    refused = error.what();
  }
  equal(
    "no publisher can insist on a flow of its own", refused,
    std::string("could not create publisher: Unique network flow endpoints not supported on publishers"));
  rclcpp::SubscriptionOptions insisting;
  insisting.require_unique_network_flow_endpoints = RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_STRICTLY_REQUIRED;
  int through_own_flow = 0;
  auto own_flow = node->create_subscription<Int32>(
    "number", 3, [&](const Int32 & msg) {through_own_flow = msg.data;}, insisting);
  publisher->publish(Int32().set__data(31));
  spin_until(node, [&] {return through_own_flow != 0;});
  equal("a subscription can, and hears", through_own_flow, 31);
  own_flow.reset();
  std::thread later([&] {
      rclcpp::sleep_for(100ms);
      publisher->publish(Int32().set__data(77));
    });
  Int32 waited;
  check("waiting for a message", rclcpp::wait_for_message(waited, node, "number", 2s));
  equal("it is the message", waited.data, 77);
  later.join();
  check("waiting for none", !rclcpp::wait_for_message(waited, node, "silence", 50ms));
  rclcpp::shutdown();
}
