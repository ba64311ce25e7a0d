// Parameters of other nodes, by their services.
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
    QoS qos(QoSInitialization::from_rmw(profile), profile);
    std::string name = remote.empty() ? base_->full_name : remote;
    remote_ = name.front() == '/' ? name : base_->space + (base_->space.back() == '/' ? "" : "/") + name;
    get_ = detail::client<rcl_interfaces::srv::GetParameters>(*base_, name + "/get_parameters", qos, group);
    types_ = detail::client<rcl_interfaces::srv::GetParameterTypes>(*base_, name + "/get_parameter_types", qos, group);
    set_ = detail::client<rcl_interfaces::srv::SetParameters>(*base_, name + "/set_parameters", qos, group);
    together_ =
      detail::client<rcl_interfaces::srv::SetParametersAtomically>(*base_, name + "/set_parameters_atomically", qos, group);
    list_ = detail::client<rcl_interfaces::srv::ListParameters>(*base_, name + "/list_parameters", qos, group);
    describe_ = detail::client<rcl_interfaces::srv::DescribeParameters>(*base_, name + "/describe_parameters", qos, group);
  }

  template<class T>
  using Future = std::shared_future<T>;
  template<class T>
  using Callback = std::function<void (Future<T>)>;
  using Results = std::vector<rcl_interfaces::msg::SetParametersResult>;
  using Descriptors = std::vector<rcl_interfaces::msg::ParameterDescriptor>;

  Future<std::vector<Parameter>> get_parameters(
    const std::vector<std::string> & names, Callback<std::vector<Parameter>> callback = nullptr)
  {
    auto request = std::make_shared<rcl_interfaces::srv::GetParameters::Request>();
    request->names = names;
    return ask_for<std::vector<Parameter>>(
      get_, request, callback, [names](auto & response) {
        std::vector<Parameter> found;
        for (size_t i = 0; i < response.values.size() && i < names.size(); ++i) {
          found.emplace_back(names[i], ParameterValue(response.values[i]));
        }
        return found;
      });
  }
  Future<std::vector<ParameterType>> get_parameter_types(
    const std::vector<std::string> & names, Callback<std::vector<ParameterType>> callback = nullptr)
  {
    auto request = std::make_shared<rcl_interfaces::srv::GetParameterTypes::Request>();
    request->names = names;
    return ask_for<std::vector<ParameterType>>(
      types_, request, callback, [](auto & response) {
        std::vector<ParameterType> types;
        for (auto type : response.types) {
          types.push_back(static_cast<ParameterType>(type));
        }
        return types;
      });
  }
  Future<Results> set_parameters(const std::vector<Parameter> & parameters, Callback<Results> callback = nullptr)
  {
    auto request = std::make_shared<rcl_interfaces::srv::SetParameters::Request>();
    request->parameters = messages_of(parameters);
    return ask_for<Results>(set_, request, callback, [](auto & response) {return response.results;});
  }
  Future<rcl_interfaces::msg::SetParametersResult> set_parameters_atomically(
    const std::vector<Parameter> & parameters, Callback<rcl_interfaces::msg::SetParametersResult> callback = nullptr)
  {
    auto request = std::make_shared<rcl_interfaces::srv::SetParametersAtomically::Request>();
    request->parameters = messages_of(parameters);
    return ask_for<rcl_interfaces::msg::SetParametersResult>(
      together_, request, callback, [](auto & response) {return response.result;});
  }
  Future<Results> delete_parameters(const std::vector<std::string> & names)
  {
    std::vector<Parameter> unset;
    for (auto & name : names) {
      unset.emplace_back(name);
    }
    return set_parameters(unset);
  }
  Future<rcl_interfaces::msg::ListParametersResult> list_parameters(
    const std::vector<std::string> & prefixes, uint64_t depth,
    Callback<rcl_interfaces::msg::ListParametersResult> callback = nullptr)
  {
    auto request = std::make_shared<rcl_interfaces::srv::ListParameters::Request>();
    request->prefixes = prefixes;
    request->depth = depth;
    return ask_for<rcl_interfaces::msg::ListParametersResult>(
      list_, request, callback, [](auto & response) {return response.result;});
  }
  Future<Descriptors> describe_parameters(const std::vector<std::string> & names, Callback<Descriptors> callback = nullptr)
  {
    auto request = std::make_shared<rcl_interfaces::srv::DescribeParameters::Request>();
    request->names = names;
    return ask_for<Descriptors>(describe_, request, callback, [](auto & response) {return response.descriptors;});
  }

  /// Set what a file says of the node that this is a client of.
  Future<Results> load_parameters(const std::string & yaml_filename)
  {
    return load_parameters(detail::parameter_file(yaml_filename, remote_));
  }
  Future<Results> load_parameters(const ParameterMap & map) {return set_parameters(parameters_from_map(map));}

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
  bool service_is_ready() const
  {
    return get_->service_is_ready() && types_->service_is_ready() && set_->service_is_ready() && list_->service_is_ready();
  }
  template<class Rep = int64_t, class Period = std::milli>
  bool wait_for_service(std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return get_->wait_for_service(timeout) && types_->wait_for_service(timeout) && set_->wait_for_service(timeout) &&
           list_->wait_for_service(timeout);
  }

private:
  static std::vector<rcl_interfaces::msg::Parameter> messages_of(const std::vector<Parameter> & parameters)
  {
    std::vector<rcl_interfaces::msg::Parameter> messages;
    for (auto & parameter : parameters) {
      messages.push_back(parameter.to_parameter_msg());
    }
    return messages;
  }
  /// Send a request; its future gets what `change` makes of the response.
  template<class T, class C, class R, class F>
  Future<T> ask_for(C & client, R request, Callback<T> callback, F change)
  {
    auto promise = std::make_shared<std::promise<T>>();
    Future<T> future = promise->get_future().share();
    client->async_send_request(
      request, [promise, future, callback, change](typename C::element_type::SharedFuture answered) {
        promise->set_value(change(*answered.get()));
        if (callback) {
          callback(future);
        }
      });
    return future;
  }
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

  template<class Rep = int64_t, class Period = std::milli>
  std::vector<Parameter> get_parameters(
    const std::vector<std::string> & names, std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return wait(client_.get_parameters(names), timeout);
  }
  bool has_parameter(const std::string & name)
  {
    auto names = list_parameters({name}, 1).names;
    return std::find(names.begin(), names.end(), name) != names.end();
  }
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
