// Keeps a struct like a node's parameters: what all listeners that generate_parameter_library() makes have in common.
#pragma once
#include <limits>
#include <map>
#include <mutex>

#include "parameter_traits/parameter_traits.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace coursekit
{
/// What parameters hold, of what the fields of a struct are.
template<class T>
T parameter_of(const T & field) {return field;}
template<class T, size_t capacity>
std::vector<T> parameter_of(const rsl::StaticVector<T, capacity> & field) {return rsl::to_vector(field);}
template<size_t capacity>
std::string parameter_of(const rsl::StaticString<capacity> & field) {return rsl::to_string(field);}

inline rcl_interfaces::msg::ParameterDescriptor described(
  const char * description, bool read_only, const char * additional_constraints)
{
  rcl_interfaces::msg::ParameterDescriptor descriptor;
  descriptor.description = description;
  descriptor.read_only = read_only;
  descriptor.additional_constraints = additional_constraints;
  return descriptor;
}
inline rcl_interfaces::msg::ParameterDescriptor in_range(
  rcl_interfaces::msg::ParameterDescriptor descriptor, double lower, double upper)
{
  descriptor.floating_point_range.resize(1);
  descriptor.floating_point_range[0].from_value = lower;
  descriptor.floating_point_range[0].to_value = upper;
  return descriptor;
}
inline rcl_interfaces::msg::ParameterDescriptor in_range(
  rcl_interfaces::msg::ParameterDescriptor descriptor, int64_t lower, int64_t upper)
{
  descriptor.integer_range.resize(1);
  descriptor.integer_range[0].from_value = lower;
  descriptor.integer_range[0].to_value = upper;
  return descriptor;
}

/// Layout has two functions that call each(name, field, has_default, descriptor, check) for parameters of a struct: fixed() for
/// those with a name of their own, and mapped() for those that exist once for each value of another parameter.
template<class Params, class StackParams, class Layout>
class ParameterListener
{
public:
  using Parameters = rclcpp::node_interfaces::NodeParametersInterface;
  using userParameterUpdateCB = std::function<void (const Params &)>;

  template<class N>
  ParameterListener(std::shared_ptr<N> node, const std::string & prefix = "")  // NOLINT
  : ParameterListener(node->get_node_parameters_interface(), node->get_logger(), prefix) {}
  ParameterListener(const std::shared_ptr<Parameters> & parameters, const std::string & prefix = "")  // NOLINT
  : ParameterListener(parameters, rclcpp::get_logger("parameters"), prefix) {}
  ParameterListener(const std::shared_ptr<Parameters> & parameters, rclcpp::Logger, const std::string & prefix = "")
  : prefix_(prefix), parameters_(parameters)
  {
    if (!prefix_.empty() && prefix_.back() != '.') {
      prefix_ += ".";
    }
    declare_params();
    handle_ = parameters_->add_on_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter> & changed) {return update(changed);});
  }
  ParameterListener(const ParameterListener &) = delete;

  Params get_params() const
  {
    std::lock_guard<std::mutex> turn(lock_);
    return params_;
  }
  bool is_old(const Params & other) const
  {
    std::lock_guard<std::mutex> turn(lock_);
    return params_.__stamp != other.__stamp;
  }
  /// Without waiting for who changes them: whether they were at hand.
  bool try_get_params(Params & params) const
  {
    std::unique_lock<std::mutex> turn(lock_, std::try_to_lock);
    if (turn && params_.__stamp != params.__stamp) {
      params = params_;
    }
    return turn.owns_lock();
  }
  /// Without waiting for who changes them: whether there were newer ones.
  bool try_update_params(Params & params) const
  {
    std::unique_lock<std::mutex> turn(lock_, std::try_to_lock);
    bool newer = turn && params_.__stamp != params.__stamp;
    if (newer) {
      params = params_;
    }
    return newer;
  }
  StackParams get_stack_params() const
  {
    StackParams out;
    Layout::stack(get_params(), out);
    return out;
  }
  void setUserCallback(const userParameterUpdateCB & callback) {user_callback_ = callback;}
  void clearUserCallback() {user_callback_ = nullptr;}

  void declare_params()
  {
    Params params = get_params();
    auto declare = [this](auto && ... words) {this->declare(words ...);};
    auto read = [this](auto && ... words) {this->read(words ...);};
    Layout::fixed(params, declare);
    Layout::fixed(params, read);
    Layout::mapped(params, declare);
    Layout::mapped(params, read);
    keep(params);
  }
  /// Declare what new values of other parameters ask for, and forget what nothing asks for any more.
  void refresh_dynamic_parameters()
  {
    Params wanted = get_params();
    Layout::mapped(wanted, [this](auto && ... words) {this->declare(words ...);});  // calls update()
    Params params = get_params();
    Layout::forget(params);
    Layout::mapped(params, [this](auto && ... words) {this->read(words ...);});
    std::lock_guard<std::mutex> turn(lock_);
    params_ = std::move(params);
  }
  rcl_interfaces::msg::SetParametersResult update(const std::vector<rclcpp::Parameter> & changed)
  {
    Params params = get_params();
    rsl::Result result;
    auto set = [&](const std::string & name, auto & field, bool, const auto &, const auto & check) {
        for (const auto & one : changed) {
          if (result && one.get_name() == prefix_ + name) {
            result = check(one);
            assign(result, field, one);
          }
        }
      };
    Layout::fixed(params, set);
    Layout::mapped(params, set);
    if (result) {
      keep(params);
      if (user_callback_) {
        user_callback_(params);
      }
    }
    return rsl::to_parameter_result_msg(result);
  }

private:
  template<class T, class F>
  void declare(
    const std::string & name, T & field, bool has_default, const rcl_interfaces::msg::ParameterDescriptor & descriptor, const F &)
  {
    if (parameters_->has_parameter(prefix_ + name)) {
      return;
    }
    rclcpp::ParameterValue value(parameter_of(field));
    if (has_default) {
      parameters_->declare_parameter(prefix_ + name, value, descriptor);
    } else {
      parameters_->declare_parameter(prefix_ + name, value.get_type(), descriptor);
    }
  }
  template<class T, class D, class F>
  void read(const std::string & name, T & field, bool, const D &, const F & check)
  {
    auto parameter = parameters_->get_parameter(prefix_ + name);
    rsl::Result result = check(parameter);
    assign(result, field, parameter);
    if (!result) {
      throw rclcpp::exceptions::InvalidParameterValueException(
              "Invalid value set during initialization for parameter '" + name + "': " + result.error());
    }
  }
  template<class T>
  void assign(const rsl::Result & result, T & field, const rclcpp::Parameter & parameter)
  {
    if (result) {
      field = parameter.template get_value<decltype(parameter_of(field))>();
    }
  }
  /// Each change has a later stamp, also where two fall into one moment.
  void keep(const Params & params)
  {
    std::lock_guard<std::mutex> turn(lock_);
    auto before = params_.__stamp;
    params_ = params;
    params_.__stamp = std::max(clock_.now(), before + rclcpp::Duration(0, 1));
  }

  std::string prefix_;
  Params params_;
  rclcpp::Clock clock_;
  std::shared_ptr<Parameters> parameters_;
  std::shared_ptr<rclcpp::node_interfaces::OnSetParametersCallbackHandle> handle_;
  userParameterUpdateCB user_callback_;
  mutable std::mutex lock_;
};
}  // namespace coursekit
