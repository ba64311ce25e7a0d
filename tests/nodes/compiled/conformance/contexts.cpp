#include "check.hpp"
#include "std_msgs/msg/int32.hpp"

using std_msgs::msg::Int32;

int main(int argc, char ** argv)
{
  check("not ok before init", !rclcpp::ok());
  rclcpp::init(argc, argv);
  check("ok after it", rclcpp::ok());
  throws<std::runtime_error>("no second init", [&] {rclcpp::init(argc, argv);});
  auto standard = rclcpp::contexts::get_global_default_context();
  check("the default context is valid", standard->is_valid());

  auto own = std::make_shared<rclcpp::Context>();
  check("another is not before its init", !own->is_valid());
  rclcpp::InitOptions options;
  options.set_domain_id(0);
  own->init(0, nullptr, options);
  check("and is then", own->is_valid() && rclcpp::ok(own));
  throws<std::runtime_error>("which it does once", [&] {own->init(0, nullptr);});
  auto node = std::make_shared<rclcpp::Node>("elsewhere", rclcpp::NodeOptions().context(own));
  auto usual = std::make_shared<rclcpp::Node>("usual");
  check("a node knows its context", node->get_node_base_interface()->get_context() == own);
  check("of the other", usual->get_node_base_interface()->get_context() == standard);
  int heard = 0;
  auto subscription = usual->create_subscription<Int32>("number", 1, [&](const Int32 & m) {heard = m.data;});
  auto publisher = node->create_publisher<Int32>("number", 1);
  publisher->publish(Int32().set__data(3));
  spin_until(usual, [&] {return heard != 0;});
  equal("both are in one graph", heard, 3);
  rclcpp::ExecutorOptions in_own;
  in_own.context = own;
  rclcpp::executors::SingleThreadedExecutor executor(in_own);
  executor.add_node(node);
  int ticks = 0;
  auto timer = node->create_wall_timer(10ms, [&] {if (++ticks == 3) {own->shutdown("enough");}});
  executor.spin();
  equal("an executor ends with its context", ticks, 3);
  check("which is over", !own->is_valid());
  equal("and why", own->shutdown_reason(), "enough");
  check("the default one goes on", rclcpp::ok());
  check("no second shutdown", !own->shutdown("again"));

  bool slept = true;
  auto third = std::make_shared<rclcpp::Context>();
  third->init(0, nullptr);
  std::thread sleeper([&] {slept = rclcpp::sleep_for(1h, third);});
  rclcpp::sleep_for(50ms);
  third->shutdown("wake up");
  sleeper.join();
  check("its end wakes who sleeps", !slept);
  std::vector<std::string> order;
  standard->add_pre_shutdown_callback([&] {order.push_back(rclcpp::ok() ? "before" : "too late");});
  rclcpp::on_shutdown([&] {order.push_back("after");});
  auto handle = standard->add_on_shutdown_callback([&] {order.push_back("never");});
  check("a callback is taken back", standard->remove_on_shutdown_callback(handle));
  check("once", !standard->remove_on_shutdown_callback(handle));
  check("shutdown", rclcpp::shutdown());
  check("callbacks in order", order == std::vector<std::string>({"before", "after"}));
  check("not ok after it", !rclcpp::ok());

  auto like_it = std::make_shared<rclcpp::contexts::DefaultContext>();
  like_it->init(0, nullptr);
  check("another of the default's kind is its own", rclcpp::ok(like_it) && !rclcpp::ok());
  rclcpp::shutdown(like_it);
  rclcpp::InitOptions fresh;
  equal("no domain is set", fresh.get_domain_id(), static_cast<size_t>(RCL_DEFAULT_DOMAIN_ID));
  fresh.set_domain_id(7);
  equal("one is", fresh.get_domain_id(), 7u);
  check("logging begins with it", fresh.auto_initialize_logging());
  check("or not", !fresh.auto_initialize_logging(false).auto_initialize_logging());
  const rclcpp::InitOptions copied = options;
  check("C's functions see each", copied.get_rcl_init_options()->impl != fresh.get_rcl_init_options()->impl);

  char name[] = "program", ros[] = "--ros-args", r[] = "-r", rule[] = "a:=b", end[] = "--", mine[] = "mine";
  char * words[] = {name, ros, r, rule, end, mine, nullptr};
  auto rest = rclcpp::init_and_remove_ros_arguments(6, words);
  check("init again, with words", rclcpp::ok());
  check("ROS's words are taken out", rest == std::vector<std::string>({"program", "mine"}));
  equal("their remapping holds", std::string(std::make_shared<rclcpp::Node>("n")->create_publisher<Int32>("a", 1)->get_topic_name()), "/b");
  check("handlers of signals are there", rclcpp::signal_handlers_installed());
  check("and taken out", rclcpp::uninstall_signal_handlers() && !rclcpp::signal_handlers_installed());
  rclcpp::shutdown();
}
