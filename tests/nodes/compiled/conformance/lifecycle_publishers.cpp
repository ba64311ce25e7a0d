// A lifecycle publisher that the program constructs itself, and that a node takes in.
#include "check.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "std_msgs/msg/int32.hpp"
using std_msgs::msg::Int32;

class Owner : public rclcpp_lifecycle::LifecycleNode
{
public:
  Owner()
  : rclcpp_lifecycle::LifecycleNode("owner")
  {
    rclcpp::PublisherOptionsWithAllocator<std::allocator<void>> options;
    publisher = std::make_shared<rclcpp_lifecycle::LifecyclePublisher<Int32>>(
      get_node_base_interface().get(), "number", rclcpp::QoS(10), options);
    get_node_topics_interface()->add_publisher(publisher, nullptr);
    add_managed_entity(publisher);
  }
  std::shared_ptr<rclcpp_lifecycle::LifecyclePublisher<Int32>> publisher;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto owner = std::make_shared<Owner>();
  auto hearer = rclcpp::Node::make_shared("hearer");
  int heard = 0;
  auto subscription = hearer->create_subscription<Int32>("number", 10, [&](const Int32 & number) {heard = number.data;});
  owner->publisher->publish(Int32().set__data(1));
  owner->configure();
  owner->activate();
  check("it is active as its node is", owner->publisher->is_activated());
  owner->publisher->publish(Int32().set__data(2));
  check("then it is heard", spin_until(hearer, [&] {return heard != 0;}));
  check("before it was not", heard == 2);
  owner->deactivate();
  check("it is silent again", !owner->publisher->is_activated());
  rclcpp::shutdown();
}
