// What is in a callback group: found by a function, each thing where it was made.
#include "check.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/trigger.hpp"

using std_msgs::msg::String;
using std_srvs::srv::Trigger;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("grouped");
  auto own = node->create_callback_group(rclcpp::CallbackGroupType::Reentrant);
  auto general = node->get_node_base_interface()->get_default_callback_group();
  rclcpp::SubscriptionOptions options;
  options.callback_group = own;
  auto heard = [](String::SharedPtr) {};
  auto first = node->create_subscription<String>("first", 1, heard, options);
  auto second = node->create_subscription<String>("second", 1, heard, options);
  auto other = node->create_subscription<String>("other", 1, heard);
  auto named = [](const std::string & name) {
      return [name](const rclcpp::SubscriptionBase::SharedPtr & one) {return one->get_topic_name() == "/" + name;};
    };
  check("a subscription is found", own->find_subscription_ptrs_if(named("second")) == second);
  check("in its group alone", own->find_subscription_ptrs_if(named("other")) == nullptr);
  check("without a group in the node's", general->find_subscription_ptrs_if(named("other")) == other);
  auto timer = node->create_wall_timer(1s, [] {}, own);
  auto client = node->create_client<Trigger>("ask", rmw_qos_profile_services_default, own);
  auto answer = [](Trigger::Request::SharedPtr, Trigger::Response::SharedPtr) {};
  auto service = node->create_service<Trigger>("answer", answer, rmw_qos_profile_services_default, own);
  auto any = [](const auto &) {return true;};
  check("a timer", own->find_timer_ptrs_if(any) == timer && general->find_timer_ptrs_if(any) == nullptr);
  check("a client", own->find_client_ptrs_if(any) == client);
  check("a service", own->find_service_ptrs_if(any) == service);
  check("no waitable", own->find_waitable_ptrs_if(any) == nullptr);
  auto counted = [&own] {
      std::string text;
      own->collect_all_ptrs(
        [&](auto) {text += "s";}, [&](auto) {text += "v";}, [&](auto) {text += "c";}, [&](auto) {text += "t";},
        [&](auto) {text += "w";});
      return text;
    };
  equal("all of them", counted(), "ssvct");
  first.reset();
  equal("but for those that are gone", counted(), "svct");
  check("an executor may take from it", own->can_be_taken_from().load());
  rclcpp::shutdown();
}
