// Parameters of other nodes: the services that are asked, and what their answers are made into.
#include "rclcpp/rclcpp.hpp"

namespace rclcpp
{
namespace
{
using rcl_interfaces::srv::DescribeParameters;
using rcl_interfaces::srv::GetParameters;
using rcl_interfaces::srv::GetParameterTypes;
using rcl_interfaces::srv::ListParameters;
using rcl_interfaces::srv::SetParameters;
using rcl_interfaces::srv::SetParametersAtomically;

std::vector<rcl_interfaces::msg::Parameter> messages_of(const std::vector<Parameter> & parameters)
{
  std::vector<rcl_interfaces::msg::Parameter> messages;
  for (auto & parameter : parameters) {
    messages.push_back(parameter.to_parameter_msg());
  }
  return messages;
}

/// Send a request; its future gets what `change` makes of the response.
template<class T, class C, class R, class F>
std::shared_future<T> ask_for(C & client, R request, AsyncParametersClient::Callback<T> callback, F change)
{
  auto promise = std::make_shared<std::promise<T>>();
  std::shared_future<T> future = promise->get_future().share();
  client->async_send_request(
    request, [promise, future, callback, change](typename C::element_type::SharedFuture answered) {
      promise->set_value(change(*answered.get()));
      if (callback) {
        callback(future);
      }
    });
  return future;
}
}  // namespace

void AsyncParametersClient::connect(
  const std::string & remote, const rmw_qos_profile_t & profile, const CallbackGroup::SharedPtr & group)
{
  QoS qos(QoSInitialization::from_rmw(profile), profile);
  std::string name = remote.empty() ? base_->full_name : remote;
  remote_ = name.front() == '/' ? name : base_->space + (base_->space.back() == '/' ? "" : "/") + name;
  get_ = detail::client<GetParameters>(*base_, name + "/get_parameters", qos, group);
  types_ = detail::client<GetParameterTypes>(*base_, name + "/get_parameter_types", qos, group);
  set_ = detail::client<SetParameters>(*base_, name + "/set_parameters", qos, group);
  together_ = detail::client<SetParametersAtomically>(*base_, name + "/set_parameters_atomically", qos, group);
  list_ = detail::client<ListParameters>(*base_, name + "/list_parameters", qos, group);
  describe_ = detail::client<DescribeParameters>(*base_, name + "/describe_parameters", qos, group);
}

AsyncParametersClient::Future<std::vector<Parameter>> AsyncParametersClient::get_parameters(
  const std::vector<std::string> & names, Callback<std::vector<Parameter>> callback)
{
  auto request = std::make_shared<GetParameters::Request>();
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

AsyncParametersClient::Future<std::vector<ParameterType>> AsyncParametersClient::get_parameter_types(
  const std::vector<std::string> & names, Callback<std::vector<ParameterType>> callback)
{
  auto request = std::make_shared<GetParameterTypes::Request>();
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

AsyncParametersClient::Future<AsyncParametersClient::Results> AsyncParametersClient::set_parameters(
  const std::vector<Parameter> & parameters, Callback<Results> callback)
{
  auto request = std::make_shared<SetParameters::Request>();
  request->parameters = messages_of(parameters);
  return ask_for<Results>(set_, request, callback, [](auto & response) {return response.results;});
}

AsyncParametersClient::Future<rcl_interfaces::msg::SetParametersResult> AsyncParametersClient::set_parameters_atomically(
  const std::vector<Parameter> & parameters, Callback<rcl_interfaces::msg::SetParametersResult> callback)
{
  auto request = std::make_shared<SetParametersAtomically::Request>();
  request->parameters = messages_of(parameters);
  return ask_for<rcl_interfaces::msg::SetParametersResult>(
    together_, request, callback, [](auto & response) {return response.result;});
}

AsyncParametersClient::Future<AsyncParametersClient::Results> AsyncParametersClient::delete_parameters(
  const std::vector<std::string> & names)
{
  std::vector<Parameter> unset;
  for (auto & name : names) {
    unset.emplace_back(name);
  }
  return set_parameters(unset);
}

AsyncParametersClient::Future<rcl_interfaces::msg::ListParametersResult> AsyncParametersClient::list_parameters(
  const std::vector<std::string> & prefixes, uint64_t depth, Callback<rcl_interfaces::msg::ListParametersResult> callback)
{
  auto request = std::make_shared<ListParameters::Request>();
  request->prefixes = prefixes;
  request->depth = depth;
  return ask_for<rcl_interfaces::msg::ListParametersResult>(
    list_, request, callback, [](auto & response) {return response.result;});
}

AsyncParametersClient::Future<AsyncParametersClient::Descriptors> AsyncParametersClient::describe_parameters(
  const std::vector<std::string> & names, Callback<Descriptors> callback)
{
  auto request = std::make_shared<DescribeParameters::Request>();
  request->names = names;
  return ask_for<Descriptors>(describe_, request, callback, [](auto & response) {return response.descriptors;});
}

AsyncParametersClient::Future<AsyncParametersClient::Results> AsyncParametersClient::load_parameters(
  const std::string & yaml_filename)
{
  return load_parameters(detail::parameter_file(yaml_filename, remote_));
}

AsyncParametersClient::Future<AsyncParametersClient::Results> AsyncParametersClient::load_parameters(const ParameterMap & map)
{
  return set_parameters(parameters_from_map(map));
}

bool AsyncParametersClient::service_is_ready() const
{
  return get_->service_is_ready() && types_->service_is_ready() && set_->service_is_ready() && list_->service_is_ready();
}

bool AsyncParametersClient::wait_for_services(std::chrono::nanoseconds timeout)
{
  return get_->wait_for_service(timeout) && types_->wait_for_service(timeout) && set_->wait_for_service(timeout) &&
         list_->wait_for_service(timeout);
}

bool SyncParametersClient::has_parameter(const std::string & name)
{
  auto names = list_parameters({name}, 1).names;
  return std::find(names.begin(), names.end(), name) != names.end();
}
}  // namespace rclcpp
