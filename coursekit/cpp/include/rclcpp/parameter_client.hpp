// Parameters of other nodes, by their services. What needs their types is compiled once, in src/parameter_client.cpp.
#pragma once
#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rcl_interfaces/srv/describe_parameters.hpp"
#include "rcl_interfaces/srv/get_parameter_types.hpp"
#include "rcl_interfaces/srv/get_parameters.hpp"
#include "rcl_interfaces/srv/list_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters.hpp"
#include "rcl_interfaces/srv/set_parameters_atomically.hpp"
#include "rclcpp/create.hpp"
#include "rclcpp/executors.hpp"
#include "rclcpp/parameter_map.hpp"

namespace rclcpp
{
class AsyncParametersClient
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(AsyncParametersClient)
  template<class N>
  explicit AsyncParametersClient(
    N && node, const std::string & remote = "", const rmw_qos_profile_t & profile = rmw_qos_profile_parameters,
    CallbackGroup::SharedPtr group = nullptr)
  : base_(base_of(node))
  {
    connect(remote, profile, group);
  }

  AsyncParametersClient(
    node_interfaces::NodeBaseInterface::SharedPtr base, node_interfaces::NodeTopicsInterface::SharedPtr,
    node_interfaces::NodeGraphInterface::SharedPtr, node_interfaces::NodeServicesInterface::SharedPtr,
    const std::string & remote = "", const rmw_qos_profile_t & profile = rmw_qos_profile_parameters,
    CallbackGroup::SharedPtr group = nullptr)
  : AsyncParametersClient(base, remote, profile, group) {}

  template<class T>
  using Future = std::shared_future<T>;
  template<class T>
  using Callback = std::function<void (Future<T>)>;
  using Results = std::vector<rcl_interfaces::msg::SetParametersResult>;
  using Descriptors = std::vector<rcl_interfaces::msg::ParameterDescriptor>;

  Future<std::vector<Parameter>> get_parameters(
    const std::vector<std::string> & names, Callback<std::vector<Parameter>> callback = nullptr);
  Future<std::vector<ParameterType>> get_parameter_types(
    const std::vector<std::string> & names, Callback<std::vector<ParameterType>> callback = nullptr);
  Future<Results> set_parameters(const std::vector<Parameter> & parameters, Callback<Results> callback = nullptr);
  Future<rcl_interfaces::msg::SetParametersResult> set_parameters_atomically(
    const std::vector<Parameter> & parameters, Callback<rcl_interfaces::msg::SetParametersResult> callback = nullptr);
  Future<Results> delete_parameters(const std::vector<std::string> & names);
  Future<rcl_interfaces::msg::ListParametersResult> list_parameters(
    const std::vector<std::string> & prefixes, uint64_t depth,
    Callback<rcl_interfaces::msg::ListParametersResult> callback = nullptr);
  Future<Descriptors> describe_parameters(const std::vector<std::string> & names, Callback<Descriptors> callback = nullptr);

  /// Set what a file says of the node that this is a client of.
  Future<Results> load_parameters(const std::string & yaml_filename);
  Future<Results> load_parameters(const ParameterMap & map);

  /// Hear of changes of all nodes' parameters; the node is that of this client, or the one that is given.
  template<class F>
  Subscription<rcl_interfaces::msg::ParameterEvent>::SharedPtr on_parameter_event(
    F && callback, const QoS & qos = ParameterEventsQoS(), const SubscriptionOptions & options = {})
  {
    return on_parameter_event(base_, std::forward<F>(callback), qos, options);
  }
  template<class F, class N, class = std::enable_if_t<!std::is_convertible_v<F, QoS>>>
  static Subscription<rcl_interfaces::msg::ParameterEvent>::SharedPtr on_parameter_event(
    N && node, F && callback, const QoS & qos = ParameterEventsQoS(), const SubscriptionOptions & options = {})
  {
    return create_subscription<rcl_interfaces::msg::ParameterEvent>(
      node, "/parameter_events", qos, std::forward<F>(callback), options);
  }
  bool service_is_ready() const;
  template<class Rep = int64_t, class Period = std::milli>
  bool wait_for_service(std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return wait_for_services(std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
  }

private:
  void connect(const std::string & remote, const rmw_qos_profile_t & profile, const CallbackGroup::SharedPtr & group);
  bool wait_for_services(std::chrono::nanoseconds timeout);

  node_interfaces::NodeBaseInterface::SharedPtr base_;
  std::string remote_;
  Client<rcl_interfaces::srv::GetParameters>::SharedPtr get_;
  Client<rcl_interfaces::srv::GetParameterTypes>::SharedPtr types_;
  Client<rcl_interfaces::srv::SetParameters>::SharedPtr set_;
  Client<rcl_interfaces::srv::SetParametersAtomically>::SharedPtr together_;
  Client<rcl_interfaces::srv::ListParameters>::SharedPtr list_;
  Client<rcl_interfaces::srv::DescribeParameters>::SharedPtr describe_;
};

/// The same, where each call spins until its answer is there.
class SyncParametersClient
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SyncParametersClient)
  template<class N, class = std::enable_if_t<!std::is_convertible_v<N, std::shared_ptr<Executor>>>>
  explicit SyncParametersClient(
    N && node, const std::string & remote = "", const rmw_qos_profile_t & profile = rmw_qos_profile_parameters)
  : SyncParametersClient(std::make_shared<executors::SingleThreadedExecutor>(), node, remote, profile) {}
  template<class N>
  SyncParametersClient(
    std::shared_ptr<Executor> executor, N && node, const std::string & remote = "",
    const rmw_qos_profile_t & profile = rmw_qos_profile_parameters)
  : executor_(std::move(executor)), base_(base_of(node)), client_(node, remote, profile) {}
  SyncParametersClient(
    std::shared_ptr<Executor> executor, node_interfaces::NodeBaseInterface::SharedPtr base,
    node_interfaces::NodeTopicsInterface::SharedPtr, node_interfaces::NodeGraphInterface::SharedPtr,
    node_interfaces::NodeServicesInterface::SharedPtr, const std::string & remote = "",
    const rmw_qos_profile_t & profile = rmw_qos_profile_parameters)
  : SyncParametersClient(std::move(executor), base, remote, profile) {}

  template<class Rep = int64_t, class Period = std::milli>
  std::vector<Parameter> get_parameters(
    const std::vector<std::string> & names, std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return wait(client_.get_parameters(names), timeout);
  }
  bool has_parameter(const std::string & name);
  template<class T>
  T get_parameter(const std::string & name)
  {
    auto found = get_parameters({name});
    if (found.empty() || found[0].get_type() == PARAMETER_NOT_SET) {
      throw std::runtime_error("Parameter '" + name + "' is not set");
    }
    return static_cast<T>(found[0].get_value<T>());
  }
  template<class T>
  T get_parameter(const std::string & name, const T & alternative)
  {
    auto found = get_parameters({name});
    return found.empty() || found[0].get_type() == PARAMETER_NOT_SET ? alternative : static_cast<T>(found[0].get_value<T>());
  }
  template<class Rep = int64_t, class Period = std::milli>
  std::vector<ParameterType> get_parameter_types(
    const std::vector<std::string> & names, std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return wait(client_.get_parameter_types(names), timeout);
  }
  template<class Rep = int64_t, class Period = std::milli>
  AsyncParametersClient::Results set_parameters(
    const std::vector<Parameter> & parameters, std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return wait(client_.set_parameters(parameters), timeout);
  }
  template<class Rep = int64_t, class Period = std::milli>
  rcl_interfaces::msg::SetParametersResult set_parameters_atomically(
    const std::vector<Parameter> & parameters, std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return wait(client_.set_parameters_atomically(parameters), timeout);
  }
  template<class Rep = int64_t, class Period = std::milli>
  AsyncParametersClient::Results delete_parameters(
    const std::vector<std::string> & names, std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return wait(client_.delete_parameters(names), timeout);
  }
  template<class Rep = int64_t, class Period = std::milli>
  rcl_interfaces::msg::ListParametersResult list_parameters(
    const std::vector<std::string> & prefixes, uint64_t depth, std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return wait(client_.list_parameters(prefixes, depth), timeout);
  }
  template<class Rep = int64_t, class Period = std::milli>
  AsyncParametersClient::Results load_parameters(
    const std::string & yaml_filename, std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return wait(client_.load_parameters(yaml_filename), timeout);
  }
  template<class Rep = int64_t, class Period = std::milli>
  AsyncParametersClient::Results load_parameters(
    const ParameterMap & map, std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return wait(client_.load_parameters(map), timeout);
  }
  template<class Rep = int64_t, class Period = std::milli>
  AsyncParametersClient::Descriptors describe_parameters(
    const std::vector<std::string> & names, std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return wait(client_.describe_parameters(names), timeout);
  }
  template<class F>
  auto on_parameter_event(F && callback)
  {
    return client_.on_parameter_event(std::forward<F>(callback));
  }
  template<class F, class N>
  static auto on_parameter_event(N && node, F && callback)
  {
    return AsyncParametersClient::on_parameter_event(node, std::forward<F>(callback));
  }
  bool service_is_ready() const {return client_.service_is_ready();}
  template<class Rep = int64_t, class Period = std::milli>
  bool wait_for_service(std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return client_.wait_for_service(timeout);
  }

private:
  /// The answer; an empty one where the time ran out or Ctrl-C came.
  template<class T, class Rep = int64_t, class Period = std::milli>
  T wait(std::shared_future<T> future, std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    auto code = executors::spin_node_until_future_complete(*executor_, base_, future, timeout);
    return code == FutureReturnCode::SUCCESS ? future.get() : T();
  }
  std::shared_ptr<Executor> executor_;
  node_interfaces::NodeBaseInterface::SharedPtr base_;
  AsyncParametersClient client_;
};
}  // namespace rclcpp
