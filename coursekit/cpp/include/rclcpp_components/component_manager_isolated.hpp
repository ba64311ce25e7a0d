// A manager that gives each component an executor and a thread of its own.
#pragma once
#include <thread>

#include "rclcpp_components/component_manager.hpp"

namespace rclcpp_components
{
template<typename ExecutorT = rclcpp::executors::SingleThreadedExecutor>
class ComponentManagerIsolated : public ComponentManager
{
public:
  using ComponentManager::ComponentManager;
  ~ComponentManagerIsolated() override
  {
    for (auto & entry : dedicated_executor_wrappers_) {
      end(entry.second);
    }
  }

protected:
  void add_node_to_executor(uint64_t node_id) override
  {
    if (!is_here(node_id)) {
      return;
    }
    DedicatedExecutorWrapper own;
    own.executor = std::make_shared<ExecutorT>();
    own.executor->add_node(node_wrappers_[node_id].get_node_base_interface());
    own.thread = std::thread([executor = own.executor] {executor->spin();});
    dedicated_executor_wrappers_[node_id] = std::move(own);
  }
  void remove_node_from_executor(uint64_t node_id) override
  {
    auto found = dedicated_executor_wrappers_.find(node_id);
    if (found != dedicated_executor_wrappers_.end()) {
      end(found->second);
      dedicated_executor_wrappers_.erase(found);
    }
  }

private:
  struct DedicatedExecutorWrapper
  {
    std::shared_ptr<rclcpp::Executor> executor;
    std::thread thread;
  };
  static void end(DedicatedExecutorWrapper & own)
  {
    while (rclcpp::ok() && !own.executor->is_spinning()) {  // one that has not begun cannot be cancelled
      rclcpp::sleep_for(std::chrono::milliseconds(1));
    }
    own.executor->cancel();
    own.thread.join();
  }
  std::unordered_map<uint64_t, DedicatedExecutorWrapper> dedicated_executor_wrappers_;
};
}  // namespace rclcpp_components
