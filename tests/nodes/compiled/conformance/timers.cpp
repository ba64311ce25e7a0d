#include "check.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("timers");
  int ticks = 0;
  auto timer = node->create_wall_timer(50ms, [&] {++ticks;});
  check("a wall timer is steady", timer->is_steady());
  check("it is not due yet", !timer->is_ready());
  check("it has its period before it", timer->time_until_trigger() <= 50ms && timer->time_until_trigger() > 0ms);
  check("it rings", spin_until(node, [&] {return ticks == 3;}));
  timer->cancel();
  check("it is cancelled", timer->is_canceled());
  rclcpp::sleep_for(120ms);
  rclcpp::spin_some(node);
  equal("it rings no more", ticks, 3);
  check("nothing is before it", timer->time_until_trigger() == std::chrono::nanoseconds::max());
  timer->reset();
  check("reset begins anew", !timer->is_canceled() && spin_until(node, [&] {return ticks == 4;}));
  timer->cancel();

  int once = 0;
  rclcpp::TimerBase::SharedPtr one_off;
  one_off = node->create_wall_timer(20ms, [&] {++once; one_off->cancel();});
  spin_until(node, [&] {return once > 0;});
  rclcpp::sleep_for(60ms);
  rclcpp::spin_some(node);
  equal("one that cancels itself", once, 1);

  int told = 0;
  auto telling = node->create_wall_timer(20ms, [&](rclcpp::TimerBase & me) {++told; me.cancel();});
  check("a callback may take its timer", spin_until(node, [&] {return told == 1;}) && telling->is_canceled());
  int ros = 0;
  auto of_clock = rclcpp::create_timer(node, node->get_clock(), rclcpp::Duration(20ms), [&] {++ros;});
  check("a timer of the node's clock", spin_until(node, [&] {return ros == 2;}));
  check("is not steady", !of_clock->is_steady());
  of_clock.reset();
  auto base = node->get_node_base_interface();
  auto timers = node->get_node_timers_interface();
  auto wall = [&](auto period, auto * of, auto * by) {return rclcpp::create_wall_timer(period, [] {}, nullptr, of, by);};
  decltype(base.get()) none = nullptr;
  throws<std::invalid_argument>("a timer without a node", [&] {wall(1ms, none, timers.get());});
  throws<std::invalid_argument>("or without who has it", [&] {wall(1ms, base.get(), none);});
  throws<std::invalid_argument>("before now", [&] {wall(-1ms, base.get(), timers.get());});
  throws<std::invalid_argument>("longer than time is", [&] {wall(std::chrono::hours::max(), base.get(), timers.get());});
  throws<std::invalid_argument>("nor of a node", [&] {node->create_wall_timer(std::chrono::hours::max(), [] {});});
  using Timer = rclcpp::GenericTimer<void (*)()>;
  auto steady = std::make_shared<rclcpp::Clock>(RCL_STEADY_TIME);
  throws<rclcpp::exceptions::RCLInvalidArgument>("one by hand before now", [&] {Timer(steady, -1ms, [] {});});
  throws<rclcpp::exceptions::RCLError>(
    "or by no clock", [] {Timer(std::make_shared<rclcpp::Clock>(RCL_CLOCK_UNINITIALIZED), 1ms, [] {});});
  int late = 0;
  auto slow = node->create_wall_timer(20ms, [&] {++late;});
  rclcpp::sleep_for(110ms);
  rclcpp::spin_some(node);
  check("missed rings are not made up for", late == 1, std::to_string(late));
  slow.reset();
  rclcpp::sleep_for(50ms);
  rclcpp::spin_some(node);
  equal("a timer that is gone is silent", late, 1);
  throws<std::invalid_argument>("no negative period", [&] {node->create_wall_timer(-1ms, [] {});});
  int zero = 0;
  auto always = node->create_wall_timer(0ms, [&] {++zero;});
  check("a period of nothing is always due", spin_until(node, [&] {return zero > 5;}));
  always->cancel();
  auto by_hand = node->create_wall_timer(1h, [&] {++ticks;});
  ticks = 0;
  check("called by hand", by_hand->call());
  by_hand->execute_callback();
  equal("its callback ran", ticks, 1);
  by_hand->cancel();
  check("a cancelled one is not called", !by_hand->call());
  rclcpp::shutdown();
  try {
    node->create_wall_timer(1s, [] {});
    check("no timer after the end", false);
  } catch (const rclcpp::exceptions::RCLError & error) {
    check("no timer after the end", true);
    equal(
      "and why", std::string(error.what()),
      "Couldn't initialize rcl timer handle: the given context is not valid, "
      "either rcl_init() was not called or rcl_shutdown() was called., at ./src/rcl/guard_condition.c:67");
  }
}
