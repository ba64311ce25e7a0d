// LifecycleNode: a node whose states others manage. The state machine and its services are the session's.
#pragma once
#include "rclcpp_lifecycle/lifecycle_publisher.hpp"
#include "rclcpp_lifecycle/node_interfaces/lifecycle_node_interface.hpp"

namespace rclcpp_lifecycle
{
class LifecycleNode : public rclcpp::NodeFace,
  public node_interfaces::LifecycleNodeInterface,
  public std::enable_shared_from_this<LifecycleNode>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(LifecycleNode)
  using CallbackReturn = node_interfaces::LifecycleNodeInterface::CallbackReturn;
  using Callback = std::function<CallbackReturn (const State &)>;

  explicit LifecycleNode(
    const std::string & node_name, const rclcpp::NodeOptions & options = rclcpp::NodeOptions(),
    bool enable_communication_interface = true)
  : LifecycleNode(node_name, "", options, enable_communication_interface) {}
  LifecycleNode(
    const std::string & node_name, const std::string & namespace_,
    const rclcpp::NodeOptions & options = rclcpp::NodeOptions(), bool enable_communication_interface = true);
  /// A node of another process has its own transitions.
  explicit LifecycleNode(rclcpp::SharedNode node)
  : NodeFace(node) {}
  ~LifecycleNode() override;

  template<class T, class Alloc = std::allocator<void>>
  std::shared_ptr<LifecyclePublisher<T, Alloc>> create_publisher(
    const std::string & topic_name, const rclcpp::QoS & qos,
    const rclcpp::PublisherOptionsWithAllocator<Alloc> & options = rclcpp::PublisherOptionsWithAllocator<Alloc>())
  {
    auto made = NodeFace::create_publisher<T, Alloc, LifecyclePublisher<T, Alloc>>(topic_name, qos, options);
    add_managed_entity(made);
    return made;
  }

  const State & get_current_state();
  std::vector<State> get_available_states();
  std::vector<Transition> get_available_transitions() {return transitions(false);}
  std::vector<Transition> get_transition_graph() {return transitions(true);}

  const State & trigger_transition(const Transition & transition) {return trigger_transition(transition.id());}
  const State & trigger_transition(const Transition & transition, CallbackReturn & ended)
  {
    return trigger_transition(transition.id(), ended);
  }
  const State & trigger_transition(uint8_t transition_id);
  const State & trigger_transition(uint8_t transition_id, CallbackReturn & ended);
#define COURSEKIT_TRANSITION(name, which) \
  const State & name() \
  { \
    CallbackReturn ended; \
    return name(ended); \
  } \
  const State & name(CallbackReturn & ended) {return trigger_transition(which, ended);} \
  bool register_on_ ## name(Callback callback) \
  { \
    callbacks_[#name] = std::move(callback); \
    return true; \
  }
  COURSEKIT_TRANSITION(configure, lifecycle_msgs::msg::Transition::TRANSITION_CONFIGURE)
  COURSEKIT_TRANSITION(cleanup, lifecycle_msgs::msg::Transition::TRANSITION_CLEANUP)
  COURSEKIT_TRANSITION(activate, lifecycle_msgs::msg::Transition::TRANSITION_ACTIVATE)
  COURSEKIT_TRANSITION(deactivate, lifecycle_msgs::msg::Transition::TRANSITION_DEACTIVATE)
  COURSEKIT_TRANSITION(shutdown, std::string("shutdown"))
#undef COURSEKIT_TRANSITION
  bool register_on_error(Callback callback)
  {
    callbacks_["error"] = std::move(callback);
    return true;
  }
  CallbackReturn on_activate(const State &) override;
  CallbackReturn on_deactivate(const State &) override;

protected:
  void add_managed_entity(std::weak_ptr<ManagedEntityInterface> entity) {entities_.push_back(std::move(entity));}
  void add_timer_handle(rclcpp::TimerBase::SharedPtr timer) {timers_.push_back(timer);}

private:
  const State & trigger_transition(const std::string & label, CallbackReturn & ended);
  std::vector<Transition> transitions(bool all);
  /// Run the function of a transition: the one that was registered, else the node's own.
  CallbackReturn run(uint8_t through, const State & before);
  CallbackReturn run_own(uint8_t through, const State & before);

  std::map<std::string, Callback> callbacks_;
  std::vector<std::weak_ptr<ManagedEntityInterface>> entities_;
  std::vector<rclcpp::TimerBase::WeakPtr> timers_;
  int64_t handler_ = 0;
};
}  // namespace rclcpp_lifecycle
