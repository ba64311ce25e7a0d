// Managed nodes: what the session's state machine asks of them.
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace rclcpp_lifecycle
{
using Numbers = lifecycle_msgs::msg::State;
using coursekit::Packer;
using coursekit::Unpacker;
using rclcpp::ask;
namespace
{
enum How {BY_LABEL, BY_ID};

/// All states by their numbers, so that references to them last.
const std::map<uint8_t, State> & states()
{
  static const auto * known = [] {
      auto * all = new std::map<uint8_t, State>;
      Unpacker answer = ask("lifecycle_states");
      for (int64_t count = answer.i(); count > 0; --count) {
        auto id = static_cast<uint8_t>(answer.i());
        all->emplace(id, State(id, answer.s()));
      }
      return all;
    }();
  return *known;
}
const char * name_of(uint8_t through)
{
  switch (through) {
    case Numbers::TRANSITION_STATE_CONFIGURING: return "configure";
    case Numbers::TRANSITION_STATE_CLEANINGUP: return "cleanup";
    case Numbers::TRANSITION_STATE_SHUTTINGDOWN: return "shutdown";
    case Numbers::TRANSITION_STATE_ACTIVATING: return "activate";
    case Numbers::TRANSITION_STATE_DEACTIVATING: return "deactivate";
    default: return "error";
  }
}
}  // namespace

LifecycleNode::LifecycleNode(
  const std::string & name, const std::string & space, const rclcpp::NodeOptions & options, bool communicates)
: NodeFace(name, space, options, true)
{
  handler_ = coursekit::add_handler(
    [this](Unpacker & from, Packer & to) {
      auto through = static_cast<uint8_t>(from.i());
      auto before = static_cast<uint8_t>(from.i());
      to.i(static_cast<int64_t>(run(through, states().at(before))));
    });
  ask("lifecycle", Packer{}.i(base_->id).i(handler_).i(communicates));
}
LifecycleNode::~LifecycleNode() {coursekit::remove_handler(handler_);}

LifecycleNode::CallbackReturn LifecycleNode::run(uint8_t through, const State & before)
{
  try {
    auto found = callbacks_.find(name_of(through));
    return found == callbacks_.end() ? run_own(through, before) : found->second(before);
  } catch (const std::exception & error) {
    RCLCPP_ERROR(get_logger(), "Caught exception in callback for transition %d", through);
    RCLCPP_ERROR(get_logger(), "Original error: %s", error.what());
    return CallbackReturn::ERROR;
  }
}
LifecycleNode::CallbackReturn LifecycleNode::run_own(uint8_t through, const State & before)
{
  switch (through) {
    case Numbers::TRANSITION_STATE_CONFIGURING: return on_configure(before);
    case Numbers::TRANSITION_STATE_CLEANINGUP: return on_cleanup(before);
    case Numbers::TRANSITION_STATE_SHUTTINGDOWN: return on_shutdown(before);
    case Numbers::TRANSITION_STATE_ACTIVATING: return on_activate(before);
    case Numbers::TRANSITION_STATE_DEACTIVATING: return on_deactivate(before);
    default: return on_error(before);
  }
}
LifecycleNode::CallbackReturn LifecycleNode::on_activate(const State &)
{
  for (auto & weak : entities_) {
    if (auto entity = weak.lock()) {
      entity->on_activate();
    }
  }
  return CallbackReturn::SUCCESS;
}
LifecycleNode::CallbackReturn LifecycleNode::on_deactivate(const State &)
{
  for (auto & weak : entities_) {
    if (auto entity = weak.lock()) {
      entity->on_deactivate();
    }
  }
  return CallbackReturn::SUCCESS;
}

const State & LifecycleNode::get_current_state()
{
  return states().at(static_cast<uint8_t>(ask("lifecycle_state", Packer{}.i(base_->id)).i()));
}
std::vector<State> LifecycleNode::get_available_states()
{
  std::vector<State> all;
  for (auto & entry : states()) {
    all.push_back(entry.second);
  }
  return all;
}
std::vector<Transition> LifecycleNode::transitions(bool all)
{
  Unpacker answer = ask("lifecycle_transitions", Packer{}.i(base_->id).i(all));
  std::vector<Transition> found;
  for (int64_t count = answer.i(); count > 0; --count) {
    auto id = static_cast<uint8_t>(answer.i());
    std::string label = answer.s();
    auto start = states().at(static_cast<uint8_t>(answer.i())), goal = states().at(static_cast<uint8_t>(answer.i()));
    found.emplace_back(id, label, std::move(start), std::move(goal));
  }
  return found;
}
const State & LifecycleNode::trigger_transition(uint8_t id)
{
  CallbackReturn ended;
  return trigger_transition(id, ended);
}
const State & LifecycleNode::trigger_transition(uint8_t id, CallbackReturn & ended)
{
  ended = static_cast<CallbackReturn>(ask("lifecycle_change", Packer{}.i(base_->id).i(BY_ID).i(id)).i());
  return get_current_state();
}
const State & LifecycleNode::trigger_transition(const std::string & label, CallbackReturn & ended)
{
  int64_t code = ask("lifecycle_change", Packer{}.i(base_->id).i(BY_LABEL).s(label)).i();
  ended = code ? static_cast<CallbackReturn>(code) : CallbackReturn::ERROR;
  return get_current_state();
}
}  // namespace rclcpp_lifecycle
