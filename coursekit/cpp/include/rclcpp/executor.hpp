// Executors: the session finds what is ready and calls back; spinning is a question that takes its time.
#pragma once
#include <algorithm>
#include <future>

#include "rclcpp/any_executable.hpp"
#include "rclcpp/future_return_code.hpp"
#include "rclcpp/memory_strategy.hpp"
#include "rclcpp/node.hpp"

namespace rclcpp
{
struct ExecutorOptions
{
  Context::SharedPtr context = contexts::get_global_default_context();
  size_t max_conditions = 0;
  memory_strategy::MemoryStrategy::SharedPtr memory_strategy;
};

/// For nodes that are no rclcpp::Node. One that is comes as a pointer to that, also from what turns into such a pointer.
template<class N>
using if_other_than_node = std::enable_if_t<std::is_base_of_v<NodeFace, N> && !std::is_base_of_v<Node, N>>;

class Executor : public coursekit::Entity
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Executor)
  using NodeBase = node_interfaces::NodeBaseInterface::SharedPtr;
  explicit Executor(const ExecutorOptions & options = ExecutorOptions(), size_t threads = 1);
  ~Executor() override;

  virtual void add_node(NodeBase node, bool notify = true);
  virtual void add_node(std::shared_ptr<Node> node, bool notify = true) {add_node(node->get_node_base_interface(), notify);}
  template<class N, class = if_other_than_node<N>>
  void add_node(std::shared_ptr<N> node, bool notify = true) {add_node(node->get_node_base_interface(), notify);}
  virtual void remove_node(NodeBase node, bool notify = true);
  virtual void remove_node(std::shared_ptr<Node> node, bool notify = true)
  {
    remove_node(node->get_node_base_interface(), notify);
  }
  template<class N, class = if_other_than_node<N>>
  void remove_node(std::shared_ptr<N> node, bool notify = true) {remove_node(node->get_node_base_interface(), notify);}
  virtual void add_callback_group(CallbackGroup::SharedPtr group, NodeBase node, bool notify = true);
  virtual void remove_callback_group(CallbackGroup::SharedPtr group, bool notify = true);
  using CallbackGroups = std::vector<CallbackGroup::WeakPtr>;
  virtual CallbackGroups get_all_callback_groups();
  virtual CallbackGroups get_manually_added_callback_groups();
  virtual CallbackGroups get_automatically_added_callback_groups_from_nodes();

  virtual void spin();
  virtual void spin_once(std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  virtual void spin_some(std::chrono::nanoseconds max_duration = std::chrono::nanoseconds(0));
  virtual void spin_all(std::chrono::nanoseconds max_duration);
  void spin_node_some(NodeBase node)
  {
    add_node(node);
    spin_some();
    remove_node(node);
  }
  void spin_node_some(std::shared_ptr<Node> node) {spin_node_some(node->get_node_base_interface());}
  template<class N, class = if_other_than_node<N>>
  void spin_node_some(std::shared_ptr<N> node) {spin_node_some(node->get_node_base_interface());}
  template<class N, class Rep = int64_t, class Period = std::milli>
  void spin_node_once(N node, std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    add_node(node);
    spin_once(std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
    remove_node(node);
  }
  /// Take another strategy for memory; the session needs none, and goes on as before.
  void set_memory_strategy(memory_strategy::MemoryStrategy::SharedPtr strategy)
  {
    if (!strategy) {
      throw std::runtime_error("Received NULL memory strategy in executor.");
    }
  }
  /// Have the spin that goes on return.
  virtual void cancel();
  bool is_spinning() {return spinning;}

  /// Run callbacks until the future is ready, at most so long (negative: without end).
  template<class F, class Rep = int64_t, class Period = std::milli>
  FutureReturnCode spin_until_future_complete(
    const F & future, std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    int64_t span = std::chrono::duration_cast<std::chrono::nanoseconds>(timeout).count();
    int64_t end = span < 0 ? -1 : coursekit::steady_now() + span;
    Turn turn(*this);
    cancelled_ = false;
    for (;;) {
      if (future.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        return FutureReturnCode::SUCCESS;
      }
      if (cancelled_ || !ok(context_)) {
        return FutureReturnCode::INTERRUPTED;
      }
      int64_t left = end < 0 ? -1 : end - coursekit::steady_now();
      if (end >= 0 && left <= 0) {
        return FutureReturnCode::TIMEOUT;
      }
      ask("spin_once", Packer{}.i(id).i(left));
    }
  }

protected:
  /// While an executor spins it cannot be spun again.
  struct Turn
  {
    explicit Turn(Executor & executor);
    ~Turn();
    Executor & executor;
  };

  // -- for executors of a program's own

  /// Wait until a callback is ready, at most so long (negative: without end).
  void wait_for_work(std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  /// The next callback that is ready now; false where there is none.
  bool get_next_ready_executable(AnyExecutable & found);
  /// The same, waited for.
  bool get_next_executable(AnyExecutable & found, std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  void execute_any_executable(AnyExecutable & found);
  void spin_once_impl(std::chrono::nanoseconds timeout);
  void spin_some_impl(std::chrono::nanoseconds max_duration, bool exhaustive);

  std::atomic_bool spinning{false};
  Context::SharedPtr context_;

private:
  std::vector<NodeBase> nodes_;
  CallbackGroups added_;
  std::atomic<bool> cancelled_{false};
  /// What wait_for_work() has found; 0 for nothing.
  std::atomic<int64_t> found_{0}, found_entity_{0};
  /// Say whose callback was found.
  void describe(AnyExecutable & found, int64_t entity);
};
}  // namespace rclcpp
