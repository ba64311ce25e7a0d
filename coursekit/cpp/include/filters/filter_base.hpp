// Filters of data: of one value at a time, or of several channels together. Parameters of their node configure them.
#pragma once
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "rclcpp/rclcpp.hpp"

namespace filters
{
namespace impl
{
/// A prefix of parameters' names with its dot.
inline std::string normalize_param_prefix(std::string prefix)
{
  return prefix.empty() || prefix.back() == '.' ? prefix : prefix + '.';
}
/// A parameter, declared where it is not; of no type where nothing sets it.
inline rclcpp::Parameter declared(rclcpp::node_interfaces::NodeParametersInterface & parameters, const std::string & name)
{
  if (!parameters.has_parameter(name)) {
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.dynamic_typing = true;  // nothing may set it yet
    parameters.declare_parameter(name, rclcpp::ParameterValue(), descriptor);
  }
  rclcpp::Parameter found;
  parameters.get_parameter(name, found);
  return found;
}
}  // namespace impl

template<typename T>
class FilterBase
{
public:
  virtual ~FilterBase() = default;
  bool configure(
    const std::string & param_prefix, const std::string & filter_name,
    const rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr & node_logger,
    const rclcpp::node_interfaces::NodeParametersInterface::SharedPtr & node_params)
  {
    if (configured_) {
      RCLCPP_WARN(node_logger->get_logger(), "Filter %s already being reconfigured", filter_name_.c_str());
    }
    if (!node_params) {
      throw std::runtime_error("Need a parameters interface to function.");
    }
    filter_name_ = filter_name;
    param_prefix_ = impl::normalize_param_prefix(param_prefix);
    logging_interface_ = node_logger;
    params_interface_ = node_params;
    configured_ = false;
    return configured_ = configure();
  }
  /// Filter a value; false where that fails.
  virtual bool update(const T & data_in, T & data_out) = 0;
  const std::string & getName() {return filter_name_;}

protected:
  virtual bool configure() = 0;
  bool getParam(const std::string & name, std::string & value) {return read<std::string>(name, value);}
  bool getParam(const std::string & name, bool & value) {return read<bool>(name, value);}
  bool getParam(const std::string & name, double & value) {return read<double>(name, value);}
  bool getParam(const std::string & name, int & value) {return read<int64_t>(name, value);}
  bool getParam(const std::string & name, unsigned int & value) {return read<int64_t>(name, value);}
  bool getParam(const std::string & name, size_t & value) {return read<int64_t>(name, value);}
  bool getParam(const std::string & name, std::vector<double> & value) {return read<std::vector<double>>(name, value);}
  bool getParam(const std::string & name, std::vector<std::string> & value)
  {
    return read<std::vector<std::string>>(name, value);
  }
  std::string filter_name_, param_prefix_;
  bool configured_ = false;
  rclcpp::node_interfaces::NodeParametersInterface::SharedPtr params_interface_;
  rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr logging_interface_;

private:
  /// Read a parameter of the filter; false, and the value as it was, where it is not set or below what the value can be.
  template<typename Stored, typename Value>
  bool read(const std::string & name, Value & value)
  {
    const rclcpp::Parameter found = impl::declared(*params_interface_, param_prefix_ + name);
    if (found.get_type() == rclcpp::PARAMETER_NOT_SET) {
      return false;
    }
    const Stored stored = found.get_value<Stored>();
    if constexpr (std::is_unsigned_v<Value> && !std::is_same_v<Value, bool>) {
      if (stored < 0) {
        return false;
      }
    }
    value = static_cast<Value>(stored);
    return true;
  }
};

template<typename T>
class MultiChannelFilterBase : public FilterBase<T>
{
public:
  bool configure(
    size_t number_of_channels, const std::string & param_prefix, const std::string & filter_name,
    const rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr & node_logger,
    const rclcpp::node_interfaces::NodeParametersInterface::SharedPtr & node_params)
  {
    number_of_channels_ = number_of_channels;
    return FilterBase<T>::configure(param_prefix, filter_name, node_logger, node_params);
  }
  virtual bool update(const std::vector<T> & data_in, std::vector<T> & data_out) = 0;
  bool update(const T &, T &) override
  {
    RCLCPP_ERROR(this->logging_interface_->get_logger(), "THIS IS A MULTI FILTER DON'T CALL SINGLE FORM OF UPDATE");
    return false;
  }

protected:
  bool configure() override = 0;
  size_t number_of_channels_ = 0;
};
}  // namespace filters
