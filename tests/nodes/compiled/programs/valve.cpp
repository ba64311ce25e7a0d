// A managed node: it says how far it is open while it is active, and its parameters make transitions fail.
#include <iostream>

#include "lifecycle_msgs/msg/transition.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "rclcpp_lifecycle/lifecycle_publisher.hpp"
#include "std_msgs/msg/string.hpp"
using namespace std::chrono_literals;
using rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface;
using rclcpp_lifecycle::State;
using lifecycle_msgs::msg::Transition;

class Valve : public rclcpp_lifecycle::LifecycleNode
{
public:
  explicit Valve(const std::string & name)
  : rclcpp_lifecycle::LifecycleNode(name)
  {
    declare_parameter("fault", "");
  }
  LifecycleNodeInterface::CallbackReturn on_configure(const State & before) override
  {
    publisher_ = create_publisher<std_msgs::msg::String>("opening", 10);
    timer_ = create_wall_timer(1s, [this] {publisher_->publish(std_msgs::msg::String());});
    return told("configure", before);
  }
  CallbackReturn on_activate(const State & before) override
  {
    LifecycleNode::on_activate(before);
    return told("activate", before);
  }
  CallbackReturn on_deactivate(const State & before) override
  {
    LifecycleNode::on_deactivate(before);
    return told("deactivate", before);
  }
  CallbackReturn on_cleanup(const State & before) override
  {
    timer_.reset();
    publisher_.reset();
    return told("cleanup", before);
  }
  CallbackReturn on_shutdown(const State & before) override {return told("shutdown", before);}

private:
  CallbackReturn told(const std::string & what, const State & before)
  {
    RCLCPP_INFO(get_logger(), "%s from %s [%d]", what.c_str(), before.label().c_str(), before.id());
    std::string fault = get_parameter("fault").as_string();
    if (fault == what + " throws") {
      throw std::runtime_error("the valve is stuck");
    }
    return fault == what + " fails" ? CallbackReturn::FAILURE : CallbackReturn::SUCCESS;
  }
  std::shared_ptr<rclcpp_lifecycle::LifecyclePublisher<std_msgs::msg::String>> publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
};

/// What a node says of itself, without the services.
void alone()
{
  auto node = std::make_shared<rclcpp_lifecycle::LifecycleNode>("alone", "/far", rclcpp::NodeOptions(), false);
  auto & state = node->get_current_state();
  std::cout << state.label() << int(state.id()) << " " << node->get_available_states().size();
  for (auto & one : node->get_available_transitions()) {
    std::cout << " " << one.label() << int(one.id()) << one.start_state().label() << ">" << one.goal_state().label();
  }
  std::cout << " " << node->get_transition_graph().size() << std::endl;
  node->register_on_configure(
    [](const State & before) {
      return before.label() == "unconfigured" ? Valve::CallbackReturn::SUCCESS : Valve::CallbackReturn::FAILURE;
    });
  node->register_on_error([](const State &) {return Valve::CallbackReturn::SUCCESS;});
  node->register_on_activate([](const State &) {return Valve::CallbackReturn::ERROR;});
  std::ostringstream walk;  // what is logged meanwhile must not stand in the middle of it
  walk << node->configure().label() << " " << node->trigger_transition(Transition::TRANSITION_CLEANUP).label() << " ";
  Valve::CallbackReturn ended;
  walk << node->configure(ended).label() << " " << (ended == Valve::CallbackReturn::SUCCESS) << " ";
  walk << node->activate(ended).label() << " " << (ended == Valve::CallbackReturn::ERROR) << " ";
  walk << node->deactivate(ended).label() << " " << node->shutdown().label() << " " << node->shutdown().label();
  std::cout << walk.str() << std::endl;
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  alone();
  auto valve = std::make_shared<Valve>("valve");
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(valve->get_node_base_interface());
  executor.spin();
  rclcpp::shutdown();
}
