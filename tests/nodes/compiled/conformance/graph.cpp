#include "check.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/trigger.hpp"

using std_msgs::msg::String;
using std_srvs::srv::Trigger;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("watcher");
  auto event = node->get_graph_event();
  equal("event begins unset", event->check(), false);
  node->wait_for_graph_change(event, 50ms);
  equal("nothing changes", event->check_and_clear(), false);
  auto publisher = node->create_publisher<String>("news", rclcpp::QoS(3).transient_local());
  node->wait_for_graph_change(event, 1s);
  equal("a publisher changes it", event->check_and_clear(), true);
  equal("event is cleared", event->check(), false);
  throws<rclcpp::exceptions::EventNotRegisteredError>(
    "foreign event", [&] {node->wait_for_graph_change(std::make_shared<rclcpp::Event>(), 1s);});
  throws<rclcpp::exceptions::InvalidEventError>("no event", [&] {node->wait_for_graph_change(nullptr, 1ms);});
  check("no namespace is the global one", node->get_service_names_and_types_by_node("watcher", "").count("/watcher/get_parameters") == 1);
  auto subscription = node->create_subscription<String>("news", 7, [](const String &) {});
  auto service = node->create_service<Trigger>("ring", [](Trigger::Request::SharedPtr, Trigger::Response::SharedPtr) {});

  equal("publishers are counted", node->count_publishers("/news"), 1u);
  equal("subscribers are counted", node->count_subscribers("news"), 1u);
  equal("nobody there", node->count_publishers("/nothing"), 0u);
  equal("publisher counts who hears it", publisher->get_subscription_count(), 1u);
  equal("subscription counts whom it hears", subscription->get_publisher_count(), 1u);
  equal("topic's type", node->get_topic_names_and_types()["/news"].at(0), "std_msgs/msg/String");
  equal("service's type", node->get_service_names_and_types()["/ring"].at(0), "std_srvs/srv/Trigger");
  equal("service by node", node->get_service_names_and_types_by_node("watcher", "/").count("/ring"), 1u);
  auto names = node->get_node_names();
  equal("node's full name is listed", std::count(names.begin(), names.end(), "/watcher"), 1);

  auto found = node->get_publishers_info_by_topic("/news");
  equal("one publisher is known", found.size(), 1u);
  equal("publisher's node", found.at(0).node_name(), "watcher");
  equal("publisher's namespace", found.at(0).node_namespace(), "/");
  equal("publisher's type", found.at(0).topic_type(), "std_msgs/msg/String");
  check("publisher's kind", found.at(0).endpoint_type() == rclcpp::EndpointType::Publisher);
  check("publisher's durability", found.at(0).qos_profile().durability() == rclcpp::DurabilityPolicy::TransientLocal);
  check("publisher's number", std::equal(std::begin(publisher->get_gid().data), std::end(publisher->get_gid().data),
    found.at(0).endpoint_gid().begin()));
  auto hearers = node->get_subscriptions_info_by_topic("/news");
  equal("one subscription is known", hearers.size(), 1u);
  check("subscription's kind", hearers.at(0).endpoint_type() == rclcpp::EndpointType::Subscription);
  publisher.reset();
  node->wait_for_graph_change(event, 1s);
  equal("its end changes it too", event->check_and_clear(), true);
  equal("and it is gone", node->count_publishers("/news"), 0u);
  throws<rclcpp::exceptions::InvalidTopicNameError>("who publishes on no topic", [&] {node->get_publishers_info_by_topic("13");});
  rclcpp::shutdown();
}
