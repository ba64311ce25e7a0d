// Executors: each is one of the session's, asked to spin.
#include "rclcpp/rclcpp.hpp"

namespace rclcpp
{
Executor::Executor(const ExecutorOptions & options, size_t threads)
: context_(options.context)
{
  id = ask("executor", Packer{}.i(static_cast<int64_t>(threads)).i(context_->number())).i();
}
Executor::~Executor()
{
  for (auto & node : nodes_) {
    node->in_executor = false;
  }
  for (auto & weak : added_) {
    if (auto group = weak.lock()) {
      group->get_associated_with_executor_atomic() = false;
    }
  }
}
Executor::Turn::Turn(Executor & executor_)
: executor(executor_)
{
  if (executor.spinning.exchange(true)) {
    throw std::runtime_error("spin() called while already spinning");
  }
}
Executor::Turn::~Turn() {executor.spinning = false;}

void Executor::add_node(NodeBase node, bool)
{
  if (node->in_executor) {
    throw std::runtime_error("Node '" + node->full_name + "' has already been added to an executor.");
  }
  node->in_executor = true;
  nodes_.push_back(node);
  ask("add_node", Packer{}.i(id).i(node->id));
}
void Executor::remove_node(NodeBase node, bool)
{
  if (!node->in_executor) {
    throw std::runtime_error("Node needs to be associated with an executor.");
  }
  auto found = std::find(nodes_.begin(), nodes_.end(), node);
  if (found == nodes_.end()) {
    throw std::runtime_error("Node needs to be associated with this executor.");
  }
  ask("remove_node", Packer{}.i(id).i(node->id));
  node->in_executor = false;
  nodes_.erase(found);
}
void Executor::add_callback_group(CallbackGroup::SharedPtr group, NodeBase node, bool)
{
  if (group->get_associated_with_executor_atomic().exchange(true)) {
    throw std::runtime_error("Callback group has already been added to an executor.");
  }
  ask("add_callback_group", Packer{}.i(id).i(group->id).i(node->id));
  added_.push_back(group);
}
void Executor::remove_callback_group(CallbackGroup::SharedPtr group, bool)
{
  auto is_it = [&](const CallbackGroup::WeakPtr & one) {return one.lock() == group;};
  auto found = std::find_if(added_.begin(), added_.end(), is_it);
  if (found == added_.end()) {
    throw std::runtime_error("Callback group needs to be associated with executor.");
  }
  ask("remove_callback_group", Packer{}.i(id).i(group->id));
  group->get_associated_with_executor_atomic() = false;
  added_.erase(found);
}
Executor::CallbackGroups Executor::get_manually_added_callback_groups() {return added_;}
Executor::CallbackGroups Executor::get_automatically_added_callback_groups_from_nodes()
{
  CallbackGroups all;
  for (auto & node : nodes_) {
    node->for_each_callback_group(
      [&](CallbackGroup::SharedPtr one) {
        if (one->automatically_add_to_executor_with_node() && !one->get_associated_with_executor_atomic()) {
          all.push_back(one);
        }
      });
  }
  return all;
}
Executor::CallbackGroups Executor::get_all_callback_groups()
{
  CallbackGroups all = get_automatically_added_callback_groups_from_nodes();
  all.insert(all.end(), added_.begin(), added_.end());
  return all;
}
void Executor::spin()
{
  Turn turn(*this);
  ask("spin", Packer{}.i(id));
}
void Executor::spin_once(std::chrono::nanoseconds timeout)
{
  Turn turn(*this);
  spin_once_impl(timeout);
}
void Executor::spin_once_impl(std::chrono::nanoseconds timeout) {ask("spin_once", Packer{}.i(id).i(timeout.count()));}
void Executor::spin_some(std::chrono::nanoseconds max_duration)
{
  spin_some_impl(max_duration, false);
}
void Executor::spin_some_impl(std::chrono::nanoseconds max_duration, bool exhaustive)
{
  Turn turn(*this);
  ask("spin_some", Packer{}.i(id).i(max_duration.count()).i(exhaustive));
}
void Executor::spin_all(std::chrono::nanoseconds max_duration)
{
  if (max_duration.count() < 0) {
    throw std::invalid_argument("max_duration must be greater than or equal to 0");
  }
  spin_some_impl(max_duration, true);
}
void Executor::wait_for_work(std::chrono::nanoseconds timeout)
{
  if (!found_) {
    Unpacker answer = ask("next_work", Packer{}.i(id).i(timeout.count()));
    found_ = answer.i();
    found_entity_ = answer.i();
  }
}
bool Executor::get_next_ready_executable(AnyExecutable & found)
{
  return get_next_executable(found, std::chrono::nanoseconds(0));
}
bool Executor::get_next_executable(AnyExecutable & found, std::chrono::nanoseconds timeout)
{
  wait_for_work(timeout);
  if (found.id) {
    coursekit::note("drop", Packer{}.i(found.id));
  }
  found.id = found_.exchange(0);
  if (found.id) {
    describe(found, found_entity_.exchange(0));
  }
  return found.id != 0;
}
void Executor::describe(AnyExecutable & found, int64_t entity)
{
  auto is_it = [&](const auto & one) {return one->id == entity;};
  for (const CallbackGroup::WeakPtr & weak : get_all_callback_groups()) {
    auto group = weak.lock();
    if (!group || !entity) {
      continue;
    }
    found.subscription = group->find_subscription_ptrs_if(is_it);
    found.timer = group->find_timer_ptrs_if(is_it);
    found.service = group->find_service_ptrs_if(is_it);
    found.client = group->find_client_ptrs_if(is_it);
    if (found.subscription || found.timer || found.service || found.client) {
      found.callback_group = group;
      auto has_it = [&](const NodeBase & node) {return node->callback_group_in_node(group);};
      auto owner = std::find_if(nodes_.begin(), nodes_.end(), has_it);
      found.node_base = owner == nodes_.end() ? nullptr : *owner;
      return;
    }
  }
}
void Executor::execute_any_executable(AnyExecutable & found)
{
  if (found.id) {
    ask("run_work", Packer{}.i(std::exchange(found.id, 0)));
  }
}
void Executor::cancel()
{
  cancelled_ = true;
  spinning = false;
  coursekit::note("cancel", Packer{}.i(id));
}

void spin(Executor::NodeBase node)
{
  SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.spin();
  executor.remove_node(node);
}
void spin_some(Executor::NodeBase node)
{
  SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.spin_some();
  executor.remove_node(node);
}

std::string to_string(const FutureReturnCode & code)
{
  static const char * const names[] = {"SUCCESS (0)", "INTERRUPTED (1)", "TIMEOUT (2)"};
  return names[static_cast<int>(code)];
}
std::ostream & operator<<(std::ostream & stream, const FutureReturnCode & code) {return stream << to_string(code);}
}  // namespace rclcpp
