#include "check.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::Time time(12, 345);
  equal("nanoseconds", time.nanoseconds(), 12000000345);
  equal("seconds", rclcpp::Time(2500000000LL).seconds(), 2.5);
  check("a time's clock is the system's", time.get_clock_type() == RCL_SYSTEM_TIME);
  builtin_interfaces::msg::Time message = time;
  equal("as message", message.sec, 12);
  check("from message it is ROS time", rclcpp::Time(message).get_clock_type() == RCL_ROS_TIME);
  equal("difference", (rclcpp::Time(5, 0) - rclcpp::Time(3, 0)).seconds(), 2.0);
  equal("sum", (time + rclcpp::Duration(1, 0)).nanoseconds(), 13000000345);
  check("order", rclcpp::Time(1, 0) < rclcpp::Time(1, 1));
  throws<std::runtime_error>("two clocks are not compared", [&] {(void)(time < rclcpp::Time(message));});
  throws<std::runtime_error>("nor subtracted", [&] {(void)(time - rclcpp::Time(message));});
  throws<std::runtime_error>("no negative time", [] {rclcpp::Time(-1, 0);});
  throws<std::overflow_error>("no overflow", [] {(void)(rclcpp::Time(std::numeric_limits<int64_t>::max()) + rclcpp::Duration(1ns));});
  equal("before the beginning", (rclcpp::Time(1, 0) - rclcpp::Duration(2, 0)).nanoseconds(), -1000000000);
  equal("as message it has whole seconds", builtin_interfaces::msg::Time(rclcpp::Time(-500000000LL)).nanosec, 500000000u);
  throws<std::underflow_error>("no underflow", [] {(void)(rclcpp::Time(std::numeric_limits<int64_t>::min()) - rclcpp::Duration(1, 0));});

  equal("duration of chrono", rclcpp::Duration(1500ms).seconds(), 1.5);
  equal("duration of seconds", rclcpp::Duration::from_seconds(0.25).nanoseconds(), 250000000);
  equal("duration as chrono", rclcpp::Duration(2, 0).to_chrono<std::chrono::milliseconds>().count(), 2000);
  equal("negative duration's nanoseconds", builtin_interfaces::msg::Duration(rclcpp::Duration(-500ms)).nanosec, 500000000u);
  equal("negative duration's seconds", builtin_interfaces::msg::Duration(rclcpp::Duration(-500ms)).sec, -1);
  equal("a duration times a number", (rclcpp::Duration(1, 0) * 2.5).seconds(), 2.5);
  throws<std::overflow_error>("too long", [] {(void)(rclcpp::Duration::max() * 5.0);});
  throws<std::runtime_error>("no negative rmw time", [] {rclcpp::Duration(-1s).to_rmw_time();});

  equal("the longest duration", rclcpp::Duration::max().nanoseconds(), 2147483647999999999);
  const auto longest = rclcpp::Duration::from_nanoseconds(std::numeric_limits<int64_t>::max());
  equal("a message has no longer seconds", builtin_interfaces::msg::Duration(longest).sec, std::numeric_limits<int32_t>::max());
  const builtin_interfaces::msg::Duration least = rclcpp::Duration::from_nanoseconds(-longest.nanoseconds());
  check("nor more negative ones", least.sec == std::numeric_limits<int32_t>::min() && least.nanosec == 0);
  check("rmw has", longest.to_rmw_time().sec == 9223372036u && rclcpp::Duration::from_rmw_time({9223372036u, 854775807u}) == longest);
  check("what is longer yet", rclcpp::Duration::from_rmw_time({1u, std::numeric_limits<uint64_t>::max()}) == longest);
  throws<std::underflow_error>("too short", [&] {(void)(rclcpp::Duration(-1ns) - longest);});

  rclcpp::Clock steady(RCL_STEADY_TIME), system(RCL_SYSTEM_TIME), ros(RCL_ROS_TIME);
  auto before = steady.now();
  rclcpp::sleep_for(100ms);
  auto passed = (steady.now() - before).seconds();
  check("sleeping takes its time", passed >= 0.099 && passed < 5.0, std::to_string(passed));
  check("std::chrono goes with it", std::abs(std::chrono::duration<double>(
      std::chrono::system_clock::now().time_since_epoch()).count() - system.now().seconds()) < 1.0);
  check("ROS time is not simulated", !ros.ros_time_is_active());
  auto until = steady.now() + rclcpp::Duration(50ms);
  check("sleep_until comes back", steady.sleep_until(until));
  check("not too early", steady.now() >= until);
  throws<std::runtime_error>("until of another clock", [&] {steady.sleep_until(system.now());});
  check("sleep_for of a clock", system.sleep_for(10ms));
  rclcpp::Clock assigned;
  assigned = rclcpp::Clock(RCL_ROS_TIME);
  check("a clock is assigned", assigned.get_clock_type() == RCL_ROS_TIME);
  auto copied = std::make_shared<rclcpp::Clock>(assigned);
  check("its time is given", rcl_enable_ros_time_override(assigned.get_clock_handle()) == RCL_RET_OK &&
    rcl_set_ros_time_override(assigned.get_clock_handle(), 7) == RCL_RET_OK);
  equal("a clock's copy is the same clock", copied->now().nanoseconds(), 7);
  rclcpp::WallRate rate(50ms);
  before = steady.now();
  for (int i = 0; i < 4; ++i) {
    check("rate sleeps", rate.sleep());
  }
  passed = (steady.now() - before).seconds();
  check("four periods", passed > 0.19 && passed < 5.0, std::to_string(passed));
  rclcpp::sleep_for(120ms);
  check("late loops do not sleep", !rate.sleep());
  check("wall rate is steady", rate.is_steady());
  check("rate is not", !rclcpp::Rate(10).is_steady());
  std::this_thread::sleep_for(10ms);
  check("a clock has started", steady.started() && steady.wait_until_started() && rclcpp::Clock(RCL_ROS_TIME).wait_until_started(1s));
  rclcpp::NodeOptions simulated;
  simulated.parameter_overrides({{"use_sim_time", true}});
  auto waiting = rclcpp::Node::make_shared("waiting", simulated);
  check("simulated time has not", !waiting->get_clock()->started() && !waiting->get_clock()->wait_until_started(50ms));
  auto follower = std::make_shared<rclcpp::Clock>(RCL_ROS_TIME);
  rclcpp::TimeSource source(waiting);
  source.attachClock(follower);
  check("a clock follows a node's time", follower->ros_time_is_active() && !follower->started());
  source.detachNode();
  check("until the node is gone", !follower->ros_time_is_active());
  throws<std::invalid_argument>(
    "only ROS time follows", [&] {source.attachClock(std::make_shared<rclcpp::Clock>(RCL_STEADY_TIME));});
  equal("a point in time of C's", rclcpp::Time(rcl_time_point_t{7, RCL_ROS_TIME}).nanoseconds(), 7);

  // time that a program gives a clock itself
  rclcpp::Clock own(RCL_ROS_TIME);
  rcl_clock_t * handle = own.get_clock_handle();
  check("a clock is taken over", rcl_enable_ros_time_override(handle) == RCL_RET_OK && own.ros_time_is_active());
  check("and set", rcl_set_ros_time_override(handle, 1337) == RCL_RET_OK && own.now() == rclcpp::Time(int64_t{1337}, RCL_ROS_TIME));
  bool came = false;
  std::thread sleeper([&] {came = own.sleep_until(rclcpp::Time(int64_t{2000}, RCL_ROS_TIME));});
  rclcpp::sleep_for(20ms);
  check("it stands still", own.now().nanoseconds() == 1337 && !came);
  rcl_set_ros_time_override(handle, 2000);
  sleeper.join();
  check("who sleeps wakes when it is time", came);
  check("it is given back", rcl_disable_ros_time_override(handle) == RCL_RET_OK && own.now().seconds() > 1000);
  check("only of ROS time", rcl_enable_ros_time_override(steady.get_clock_handle()) != RCL_RET_OK);
  auto turned = rclcpp::Node::make_shared("turned");
  bool slept = true;
  std::thread interrupted([&] {slept = turned->get_clock()->sleep_for(1h);});
  rclcpp::sleep_for(50ms);
  turned->set_parameter({"use_sim_time", true});
  interrupted.join();
  check("who sleeps wakes where time becomes another", !slept);
  throws<std::runtime_error>("no sleep without a context", [&] {steady.sleep_for(1ms, nullptr);});
  throws<std::runtime_error>("nor with one that has not begun", [&] {steady.sleep_for(1ms, std::make_shared<rclcpp::Context>());});
  rclcpp::shutdown();
}
