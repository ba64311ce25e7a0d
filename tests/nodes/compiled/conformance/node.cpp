#include "check.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/trigger.hpp"

using std_msgs::msg::String;
using std_srvs::srv::Trigger;

/// A class that has some of a node's interfaces, and is none.
struct Half
{
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr get_node_base_interface() {return node->get_node_base_interface();}
  rclcpp::node_interfaces::NodeTimersInterface::SharedPtr get_node_timers_interface() {return node->get_node_timers_interface();}
  rclcpp::Node::SharedPtr node;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("probe", "/lab");
  equal("name", std::string(node->get_name()), "probe");
  equal("namespace", std::string(node->get_namespace()), "/lab");
  equal("full name", std::string(node->get_fully_qualified_name()), "/lab/probe");
  equal("logger is named by dots", std::string(node->get_logger().get_name()), "lab.probe");
  equal("child logger", std::string(node->get_logger().get_child("arm").get_name()), "lab.probe.arm");
  equal("namespace gets its slash", std::string(rclcpp::Node("slashless", "ns").get_namespace()), "/ns");
  throws<rclcpp::exceptions::InvalidNodeNameError>("bad name", [] {rclcpp::Node("no spaces");});
  throws<rclcpp::exceptions::InvalidNamespaceError>("bad namespace", [] {rclcpp::Node("n", "a b");});
  throws<rclcpp::exceptions::InvalidTopicNameError>("bad topic", [&] {node->create_publisher<String>("1st", 1);});
  throws<rclcpp::exceptions::InvalidServiceNameError>("bad service", [&] {node->create_client<Trigger>("what?");});
  try {
    node->create_publisher<String>("a topic", 1);
  } catch (const rclcpp::exceptions::NameValidationError & error) {
    equal("what name is bad", error.name_type + " " + error.name, "topic name a topic");
    check("why a name is bad", error.error_msg.find("must not contain characters other than") != std::string::npos);
    equal("where a name is bad", error.invalid_index, 1u);
    equal("text about a bad name", std::string(error.what()),
      "Invalid topic name: " + error.error_msg + ":\n  'a topic'\n    ^\n");
  }
  equal("node's clock is ROS time", static_cast<int>(node->get_clock()->get_clock_type()), static_cast<int>(RCL_ROS_TIME));
  equal("default group is exclusive", node->get_node_base_interface()->get_default_callback_group()->type() ==
    rclcpp::CallbackGroupType::MutuallyExclusive, true);

  rclcpp::NodeOptions options;
  options.arguments({"--ros-args", "-r", "__node:=renamed", "-r", "chatter:=talk", "-p", "speed:=3"});
  options.append_parameter_override("colour", "blue");
  auto other = std::make_shared<rclcpp::Node>("first", options);
  equal("arguments rename", std::string(other->get_name()), "renamed");
  equal("arguments remap", std::string(other->create_publisher<String>("chatter", 1)->get_topic_name()), "/talk");
  equal("arguments set parameters", other->declare_parameter("speed", 1), 3);
  equal("overrides set parameters", other->declare_parameter<std::string>("colour", "red"), "blue");
  equal("options are kept", other->get_node_options().arguments().size(), 7u);
  rclcpp::NodeOptions automatic;
  automatic.parameter_overrides({{"given", 7}}).automatically_declare_parameters_from_overrides(true);
  equal("overrides are declared by themselves", rclcpp::Node("auto", automatic).get_parameter("given").as_int(), 7);
  equal("undeclared parameters are allowed where asked for",
    rclcpp::Node("free", rclcpp::NodeOptions().allow_undeclared_parameters(true)).set_parameter({"new", 1}).successful, true);
  Half half{node};
  auto of_half = rclcpp::create_timer(half, node->get_clock(), rclcpp::Duration(1h), [] {});
  equal("what has a node's interfaces will do", rclcpp::node_interfaces::get_node_base_interface(half), node->get_node_base_interface());
  auto * handle = node->get_node_base_interface()->get_rcl_node_handle();
  equal("a logger of C's node", std::string(rclcpp::get_node_logger(handle).get_name()), node->get_logger().get_name());
  equal("of none", std::string(rclcpp::get_node_logger(nullptr).get_name()), "rclcpp");
  rclcpp::NodeOptions plain = rcl_get_default_allocator();
  plain.use_global_arguments(false).enable_rosout(false);
  const rcl_node_options_t * seen = plain.get_rcl_node_options();
  check("C's functions see its options", !seen->use_global_arguments && !seen->enable_rosout);

  auto sub_node = node->create_sub_node("arm");
  equal("sub-node's sub-namespace", sub_node->get_sub_namespace(), "arm");
  equal("sub-node's effective namespace", sub_node->get_effective_namespace(), "/lab/arm");
  equal("sub-node's names are below it", std::string(sub_node->create_publisher<String>("joint", 1)->get_topic_name()),
    "/lab/arm/joint");
  equal("sub-node leaves absolute names", std::string(sub_node->create_publisher<String>("/joint", 1)->get_topic_name()), "/joint");
  equal("sub-node of a sub-node", sub_node->create_sub_node("hand")->get_effective_namespace(), "/lab/arm/hand");
  equal("sub-node is the same node", std::string(sub_node->get_fully_qualified_name()), "/lab/probe");
  throws<rclcpp::exceptions::NameValidationError>("empty sub-namespace", [&] {node->create_sub_node("");});
  throws<rclcpp::exceptions::InvalidNamespaceError>("no sub-namespace", [&] {node->create_sub_node("no arm?");});
  throws<rclcpp::exceptions::NameValidationError>("absolute sub-namespace", [&] {node->create_sub_node("/arm");});
  equal("private name", std::string(node->create_publisher<String>("~/state", 1)->get_topic_name()), "/lab/probe/state");

  // names in full
  auto topics = node->get_node_topics_interface();
  equal("a topic in full", topics->resolve_topic_name("x"), "/lab/x");
  equal("a private topic in full", topics->resolve_topic_name("~/x"), "/lab/probe/x");
  equal("a service in full", node->get_node_services_interface()->resolve_service_name("/x"), "/x");
  equal("a name as another node's", rclcpp::expand_topic_or_service_name("{node}/x", "a", "/ns"), "/ns/a/x");
  throws<rclcpp::exceptions::InvalidTopicNameError>(
    "no name of a topic", [&] {rclcpp::expand_topic_or_service_name("a b", "a", "/ns");});
  throws<rclcpp::exceptions::InvalidServiceNameError>(
    "no name of a service", [&] {rclcpp::expand_topic_or_service_name("a b", "a", "/ns", true);});
  throws<rclcpp::exceptions::InvalidNodeNameError>(
    "no name of a node", [&] {rclcpp::expand_topic_or_service_name("a", "a b", "/ns");});
  throws<rclcpp::exceptions::InvalidNamespaceError>(
    "no namespace", [&] {rclcpp::expand_topic_or_service_name("a", "a", "ns");});
  rclcpp::shutdown();
}
