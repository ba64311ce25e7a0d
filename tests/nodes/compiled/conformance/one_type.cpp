// Within a program a topic, service or action has one type: what comes with another is refused.
#include "check.hpp"
#include "example_interfaces/action/fibonacci.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "std_msgs/msg/empty.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/set_bool.hpp"
#include "std_srvs/srv/trigger.hpp"
#include "test_msgs/action/nested_message.hpp"

using example_interfaces::action::Fibonacci;
using std_msgs::msg::Empty;
using std_msgs::msg::String;
using std_srvs::srv::SetBool;
using std_srvs::srv::Trigger;
using test_msgs::action::NestedMessage;

template<class F>
void refuses(const std::string & name, const std::string & wanted, F make)
{
  try {
    make();
  } catch (const rclcpp::exceptions::RCLError & error) {
    return check(name, std::string(error.what()).find(wanted) == 0, error.what());
  }
  check(name, false, "threw nothing");
}
std::string words(const std::string & end, const std::string & name)
{
  const std::string kind = end == "client" || end == "service" ? "request topic name rq/s" : "topic name rt/t";
  return "could not create " + end + ": create_" + end + "() called for existing " + kind + name;
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto one = rclcpp::Node::make_shared("one"), other = rclcpp::Node::make_shared("other");
  auto publisher = one->create_publisher<String>("t", 1);
  const std::string empty = " with incompatible type std_msgs::msg::dds_::Empty_";
  refuses("a second publisher", words("publisher", empty), [&] {one->create_publisher<Empty>("t", 1);});
  refuses("a subscription of another node", words("subscription", empty), [&] {
      other->create_subscription<Empty>("t", 1, [](Empty::SharedPtr) {});
    });
  publisher.reset();
  check("another type once it is gone", one->create_publisher<Empty>("t", 1) != nullptr);
  auto client = one->create_client<Trigger>("s");
  const std::string set_bool = "Request with incompatible type std_srvs::srv::dds_::SetBool_Request_";
  refuses("a service", words("service", set_bool), [&] {
      other->create_service<SetBool>("s", [](SetBool::Request::SharedPtr, SetBool::Response::SharedPtr) {});
    });
  refuses("a second client", words("client", set_bool), [&] {other->create_client<SetBool>("s");});
  auto goals = rclcpp_action::create_client<Fibonacci>(one, "count");
  refuses("an action", "could not create action client: create_client() called for existing request topic name "
    "rq/count/_action/send_goalRequest", [&] {rclcpp_action::create_client<NestedMessage>(other, "count");});
  rclcpp::shutdown();
}
