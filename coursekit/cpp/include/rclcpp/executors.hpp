// The kinds of executors, and spinning without naming one.
#pragma once
#include <thread>

#include "rclcpp/executor.hpp"

namespace rclcpp
{
namespace executors
{
class SingleThreadedExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SingleThreadedExecutor)
  explicit SingleThreadedExecutor(const ExecutorOptions & options = ExecutorOptions())
  : Executor(options) {}
};
class MultiThreadedExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(MultiThreadedExecutor)
  explicit MultiThreadedExecutor(
    const ExecutorOptions & options = ExecutorOptions(), size_t number_of_threads = 0, bool = false,
    std::chrono::nanoseconds = std::chrono::nanoseconds(-1))
  : Executor(options, number(number_of_threads)), threads_(number(number_of_threads)) {}
  size_t get_number_of_threads() {return threads_;}

private:
  static size_t number(size_t wanted)
  {
    return wanted ? wanted : std::max<size_t>(std::thread::hardware_concurrency(), 2);
  }
  size_t threads_;
};
class StaticSingleThreadedExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(StaticSingleThreadedExecutor)
  explicit StaticSingleThreadedExecutor(const ExecutorOptions & options = ExecutorOptions())
  : Executor(options) {}
};

template<class F, class Rep = int64_t, class Period = std::milli>
FutureReturnCode spin_node_until_future_complete(
  Executor & executor, Executor::NodeBase node, const F & future,
  std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
{
  executor.add_node(node);
  auto code = executor.spin_until_future_complete(future, timeout);
  executor.remove_node(node);
  return code;
}
template<class N, class F, class Rep = int64_t, class Period = std::milli, class = std::enable_if_t<std::is_base_of_v<NodeFace, N>>>
FutureReturnCode spin_node_until_future_complete(
  Executor & executor, std::shared_ptr<N> node, const F & future,
  std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
{
  return spin_node_until_future_complete(executor, node->get_node_base_interface(), future, timeout);
}
}  // namespace executors
using executors::MultiThreadedExecutor;
using executors::SingleThreadedExecutor;

void spin(Executor::NodeBase node);
void spin_some(Executor::NodeBase node);
inline void spin(std::shared_ptr<Node> node) {spin(node->get_node_base_interface());}
inline void spin_some(std::shared_ptr<Node> node) {spin_some(node->get_node_base_interface());}
template<class N, class = if_other_than_node<N>>
void spin(std::shared_ptr<N> node) {spin(node->get_node_base_interface());}
template<class N, class = if_other_than_node<N>>
void spin_some(std::shared_ptr<N> node) {spin_some(node->get_node_base_interface());}

template<class N, class F, class Rep = int64_t, class Period = std::milli>
FutureReturnCode spin_until_future_complete(
  N node, const F & future, std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
{
  SingleThreadedExecutor executor;
  return executors::spin_node_until_future_complete(executor, base_of(node), future, timeout);
}
}  // namespace rclcpp
