// Less usual shapes of programs: allocators of their own, components by name, filters in a class, helpers of other packages.
#include <list>
#include <sstream>

#include "check.hpp"
#include "class_loader/class_loader.hpp"
#include "geometry_msgs/msg/point_stamped.hpp"
#include "message_filters/subscriber.h"
#include "rclcpp/strategies/allocator_memory_strategy.hpp"
#include "rclcpp/version.h"
#include "rclcpp_components/register_node_macro.hpp"
#include "rcpputils/asserts.hpp"
#include "rcpputils/join.hpp"
#include "rcpputils/scope_exit.hpp"
#include "rcpputils/split.hpp"
#include "rcutils/error_handling.h"
#include "std_msgs/msg/u_int32.hpp"
#include "tf2_ros/create_timer_ros.h"
#include "tf2_ros/message_filter.h"
#include "tf2_ros/transform_listener.h"

using std_msgs::msg::UInt32;

static int g_made = 0, g_freed = 0;
template<class T = void>
struct Counting
{
  using value_type = T;
  Counting() noexcept = default;
  template<class U>
  Counting(const Counting<U> &) noexcept {}  // NOLINT
  T * allocate(size_t count)
  {
    ++g_made;
    return static_cast<T *>(std::malloc(count * sizeof(std::conditional_t<std::is_void_v<T>, char, T>)));
  }
  void deallocate(T * at, size_t)
  {
    ++g_freed;
    std::free(at);
  }
  template<class U>
  struct rebind {using other = Counting<U>;};
};

class Beacon : public rclcpp::Node
{
public:
  explicit Beacon(const rclcpp::NodeOptions & options)
  : Node("beacon", options) {}
};
RCLCPP_COMPONENTS_REGISTER_NODE(Beacon)

/// A node with a filter among its members, as the tutorial about stamped messages has it.
class Drawer : public rclcpp::Node
{
public:
  Drawer()
  : Node("drawer")
  {
    buffer_ = std::make_shared<tf2_ros::Buffer>(get_clock());
    buffer_->setCreateTimerInterface(
      std::make_shared<tf2_ros::CreateTimerROS>(get_node_base_interface(), get_node_timers_interface()));
    listener_ = std::make_shared<tf2_ros::TransformListener>(*buffer_);
    points_.subscribe(this, "points", rclcpp::QoS(10).get_rmw_qos_profile());
    filter_ = std::make_shared<tf2_ros::MessageFilter<geometry_msgs::msg::PointStamped>>(
      points_, *buffer_, "base", 100, get_node_logging_interface(), get_node_clock_interface(), std::chrono::duration<int>(1));
    filter_->registerCallback(&Drawer::hear, this);
  }
  int heard = 0;

private:
  void hear(const geometry_msgs::msg::PointStamped::SharedPtr) {++heard;}
  std::shared_ptr<tf2_ros::Buffer> buffer_;
  std::shared_ptr<tf2_ros::TransformListener> listener_;
  message_filters::Subscriber<geometry_msgs::msg::PointStamped> points_;
  std::shared_ptr<tf2_ros::MessageFilter<geometry_msgs::msg::PointStamped>> filter_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("shapes", rclcpp::NodeOptions().use_intra_process_comms(true));

  // an allocator of the program's own
  using Traits = rclcpp::allocator::AllocRebind<UInt32, Counting<>>;
  using Allocator = Traits::allocator_type;
  using Deleter = rclcpp::allocator::Deleter<Allocator, UInt32>;
  auto allocator = std::make_shared<Counting<>>();
  rclcpp::PublisherOptionsWithAllocator<Counting<>> sending;
  sending.allocator = allocator;
  auto publisher = node->create_publisher<UInt32>("counted", 10, sending);
  rclcpp::SubscriptionOptionsWithAllocator<Counting<>> hearing;
  hearing.allocator = allocator;
  uint32_t heard = 0;
  auto memory = std::make_shared<rclcpp::message_memory_strategy::MessageMemoryStrategy<UInt32, Counting<>>>(allocator);
  auto subscription = node->create_subscription<UInt32>("counted", 10, [&](UInt32::SharedPtr m) {heard = m->data;}, hearing, memory);
  rclcpp::ExecutorOptions options;
  options.memory_strategy =
    std::make_shared<rclcpp::memory_strategies::allocator_memory_strategy::AllocatorMemoryStrategy<Counting<>>>(allocator);
  rclcpp::executors::SingleThreadedExecutor executor(options);
  executor.add_node(node);
  Allocator own = *allocator;
  Deleter deleter;
  rclcpp::allocator::set_allocator_for_deleter(&deleter, &own);
  auto raw = Traits::allocate(own, 1);
  Traits::construct(own, raw);
  std::unique_ptr<UInt32, Deleter> message(raw, deleter);
  message->data = 6;
  publisher->publish(std::move(message));
  for (int i = 0; i < 100 && !heard; ++i) {
    executor.spin_once(10ms);
  }
  equal("a message of another allocator arrives", heard, 6u);
  check("both sides' messages are made and freed by it", g_made == 2 && g_freed == 2, std::to_string(g_made) + std::to_string(g_freed));

  // components that are linked in
  auto loader = class_loader::ClassLoader::Make("");
  auto classes = loader->getAvailableClasses<rclcpp_components::NodeFactory>();
  check("linked classes are known", classes == std::vector<std::string>({"rclcpp_components::NodeFactoryTemplate<Beacon>"}));
  auto factory = loader->createInstance<rclcpp_components::NodeFactory>(classes[0]);
  auto made = factory->create_node_instance(rclcpp::NodeOptions());
  equal("one is made by its name", std::string(made.get_node_base_interface()->get_name()), "beacon");
  class_loader::ClassLoader lazy("", true);
  check("nothing is loaded before it is asked for", !lazy.isLibraryLoaded());
  {
    auto one = lazy.createInstance<rclcpp_components::NodeFactory>(classes[0]);
    auto other = lazy.createUniqueInstance<rclcpp_components::NodeFactory>(classes[0]);
    check("a library that is used stays", lazy.unloadLibrary() == 1 && lazy.isLibraryLoaded());
  }
  check("it goes with its last object", !lazy.isLibraryLoaded());
  throws<class_loader::LibraryLoadException>("a library cannot be loaded", [] {class_loader::ClassLoader("libother.so");});
  throws<class_loader::CreateClassException>("nor a class made that is not there", [&] {
      loader->createInstance<rclcpp_components::NodeFactory>("Nothing");
    });
  check("a node with a filter of tf2", std::make_shared<Drawer>()->heard == 0);

  // helpers
  check("fields name their types", std::is_same_v<UInt32::_data_type, uint32_t>);
  check("version", RCLCPP_VERSION_GTE(16, 0, 0) && !RCLCPP_VERSION_GTE(17, 0, 0) && RCLCPP_VERSION_MAJOR == 16);
  equal("join", rcpputils::join(std::vector<std::string>{"a", "b"}, ", "), "a, b");
  equal("split", rcpputils::split("a:b::c", ':', true).size(), 3u);
  throws<std::invalid_argument>("require", [] {rcpputils::require_true(false);});
  bool left = false;
  {
    RCPPUTILS_SCOPE_EXIT(left = true);
  }
  check("at a scope's end", left);
  equal("no error is set", std::string(rcutils_get_error_string().str), "error not set");
  std::ostringstream flow;
  flow << rclcpp::NetworkFlowEndpoint();
  check("a flow as text", flow.str().find("\"transportPort\": \"0\"") != std::string::npos);
  rclcpp::PublisherOptions unique;
  unique.require_unique_network_flow_endpoints = RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_OPTIONALLY_REQUIRED;
  check("an option about flows", node->create_publisher<UInt32>("flow", 1, unique)->get_network_flow_endpoints().empty());
  rclcpp::shutdown();
}
