#include "check.hpp"
#include "rmw/qos_policy_kind.h"
#include "rmw/qos_string_conversions.h"
#include "std_msgs/msg/string.hpp"

using std_msgs::msg::String;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::QoS ten(10);
  equal("depth", ten.depth(), 10u);
  check("default keeps the last", ten.history() == rclcpp::HistoryPolicy::KeepLast);
  check("default is reliable", ten.reliability() == rclcpp::ReliabilityPolicy::Reliable);
  check("default is volatile", ten.durability() == rclcpp::DurabilityPolicy::Volatile);
  check("sensor data is best effort", rclcpp::SensorDataQoS().reliability() == rclcpp::ReliabilityPolicy::BestEffort);
  equal("sensor data's depth", rclcpp::SensorDataQoS().depth(), 5u);
  equal("parameters' depth", rclcpp::ParametersQoS().depth(), 1000u);
  equal("services' depth", rclcpp::ServicesQoS().depth(), 10u);
  equal("parameter events' depth", rclcpp::ParameterEventsQoS().depth(), 1000u);
  check("rosout is latched", rclcpp::RosoutQoS().durability() == rclcpp::DurabilityPolicy::TransientLocal);
  equal("rosout's lifespan", rclcpp::RosoutQoS().lifespan().seconds(), 10.0);
  check("clock is best effort", rclcpp::ClockQoS().reliability() == rclcpp::ReliabilityPolicy::BestEffort);
  check("system default leaves open", rclcpp::SystemDefaultsQoS().reliability() == rclcpp::ReliabilityPolicy::SystemDefault);
  check("keep all", rclcpp::QoS(rclcpp::KeepAll()).history() == rclcpp::HistoryPolicy::KeepAll);
  auto chained = rclcpp::QoS(rclcpp::KeepLast(2)).best_effort().transient_local().deadline(rclcpp::Duration(100ms))
    .lifespan(rclcpp::Duration(1, 500)).liveliness(rclcpp::LivelinessPolicy::ManualByTopic).liveliness_lease_duration(2s);
  check("chained reliability", chained.reliability() == rclcpp::ReliabilityPolicy::BestEffort);
  equal("chained deadline", chained.deadline().nanoseconds(), 100000000);
  equal("chained lifespan", chained.get_rmw_qos_profile().lifespan.nsec, 500u);
  check("chained liveliness", chained.liveliness() == rclcpp::LivelinessPolicy::ManualByTopic);
  equal("chained lease", chained.liveliness_lease_duration().seconds(), 2.0);
  check("equal ones", rclcpp::QoS(3) == rclcpp::QoS(3));
  check("different ones", rclcpp::QoS(3) != rclcpp::QoS(3).best_effort());
  rclcpp::QoS from_profile(rclcpp::QoSInitialization::from_rmw(rmw_qos_profile_sensor_data), rmw_qos_profile_sensor_data);
  check("from rmw's profile", from_profile == rclcpp::SensorDataQoS());
  equal("a policy's name", rclcpp::qos_policy_name_from_kind(RMW_QOS_POLICY_DURABILITY), "DURABILITY_QOS_POLICY");
  equal("a policy's word", std::string(rmw_qos_policy_kind_to_str(RMW_QOS_POLICY_LIFESPAN)), "lifespan");
  std::ostringstream kinds;
  kinds << rclcpp::QosPolicyKind::Depth << " " << rclcpp::QosPolicyKind::AvoidRosNamespaceConventions;
  equal("kinds in a stream", kinds.str(), "depth avoid_ros_namespace_conventions");
  throws<std::invalid_argument>("no kind's word", [] {rclcpp::qos_policy_kind_to_cstr(rclcpp::QosPolicyKind::Invalid);});
  equal("a history's word", std::string(rmw_qos_history_policy_to_str(RMW_QOS_POLICY_HISTORY_KEEP_ALL)), "keep_all");
  equal("a reliability's word", std::string(rmw_qos_reliability_policy_to_str(RMW_QOS_POLICY_RELIABILITY_RELIABLE)), "reliable");
  equal("a word's durability", rmw_qos_durability_policy_from_str("transient_local"), RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL);
  equal("no word's liveliness", rmw_qos_liveliness_policy_from_str("dead"), RMW_QOS_POLICY_LIVELINESS_UNKNOWN);
  check("the unknown has no word", rmw_qos_liveliness_policy_to_str(RMW_QOS_POLICY_LIVELINESS_UNKNOWN) == nullptr);

  auto verdict = rclcpp::qos_check_compatible(rclcpp::QoS(1).best_effort(), rclcpp::QoS(1));
  check("best effort does not suit reliable", verdict.compatibility == rclcpp::QoSCompatibility::Error);
  check("and why", verdict.reason.find("Best effort publisher and reliable subscription") != std::string::npos);
  auto automatic = rclcpp::QoS(10).liveliness(rclcpp::LivelinessPolicy::Automatic);
  check("the same suits", rclcpp::qos_check_compatible(automatic, automatic).compatibility == rclcpp::QoSCompatibility::Ok);

  // events
  auto node = rclcpp::Node::make_shared("qos");
  int missed = 0, refused = 0, alive = -1;
  rclcpp::SubscriptionOptions options;
  options.event_callbacks.deadline_callback = [&](rclcpp::QOSDeadlineRequestedInfo & info) {missed = info.total_count;};
  options.event_callbacks.liveliness_callback = [&](rclcpp::QOSLivelinessChangedInfo & info) {alive = info.alive_count;};
  auto quick = rclcpp::QoS(1).deadline(rclcpp::Duration(50ms));
  auto subscription = node->create_subscription<String>("quick", quick, [](const String &) {}, options);
  auto publisher = node->create_publisher<String>("quick", quick);
  publisher->publish(String());
  spin_until(node, [&] {return missed >= 2;});
  check("deadlines are missed", missed >= 2);
  equal("one publisher is alive", alive, 1);
  rclcpp::PublisherOptions refusing;
  refusing.event_callbacks.incompatible_qos_callback =
    [&](rclcpp::QOSOfferedIncompatibleQoSInfo & info) {refused = info.last_policy_kind;};
  auto lax = node->create_publisher<String>("quick", rclcpp::QoS(1), refusing);
  spin_until(node, [&] {return refused != 0;});
  equal("what does not suit is told", refused, static_cast<int>(RMW_QOS_POLICY_DEADLINE));

  try {
    node->create_publisher<String>("alive", rclcpp::QoS(1).liveliness(RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_NODE));
    check("no liveliness by node", false);
  } catch (const rclcpp::exceptions::RCLError & error) {
    equal(
      "no liveliness by node", std::string(error.what()),
      "could not create publisher: create_publisher() failed setting topic QoS, at ./src/publisher.cpp:226, "
      "at ./src/rcl/publisher.c:116");
  }

  equal("the system's is a number of messages, too", static_cast<int>(rclcpp::SystemDefaultsQoS().history()),
    static_cast<int>(rclcpp::HistoryPolicy::KeepLast));
  equal("words for a depth", rclcpp::qos_policy_name_from_kind(RMW_QOS_POLICY_DEPTH), "DEPTH_QOS_POLICY");
  rclcpp::QoS bare(10);
  check("names as they are make another profile", bare.avoid_ros_namespace_conventions(true) != rclcpp::QoS(10));
  check("that of /rosout", rclcpp::RosoutQoS() == rclcpp::QoS(
      rclcpp::QoSInitialization::from_rmw(rcl_qos_profile_rosout_default), rcl_qos_profile_rosout_default));

  // overridden by parameters
  rclcpp::NodeOptions overriding;
  overriding.parameter_overrides({{"qos_overrides./told.publisher.depth", 42}});
  auto told = std::make_shared<rclcpp::Node>("overridden", overriding);
  rclcpp::PublisherOptions allowing;
  allowing.qos_overriding_options = rclcpp::QosOverridingOptions::with_default_policies();
  equal("a parameter overrides the depth", told->create_publisher<String>("told", 1, allowing)->get_actual_qos().depth(), 42u);
  allowing.qos_overriding_options = rclcpp::QosOverridingOptions::with_default_policies(
    [](const rclcpp::QoS &) {return rclcpp::QosCallbackResult{false, "too deep"};}, "deep");
  throws<rclcpp::exceptions::InvalidQosOverridesException>(
    "a callback refuses a profile", [&] {told->create_publisher<String>("told", 1, allowing);});
  rclcpp::shutdown();
}
