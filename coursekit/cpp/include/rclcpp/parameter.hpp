// Parameters: a name and a value.
#pragma once
#include "rcl_interfaces/msg/parameter.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/parameter_value.hpp"

namespace rclcpp
{
class Parameter
{
  /// A wrong type is told with the parameter's name.
  template<class Get>
  decltype(auto) checked(Get get) const
  {
    try {
      return get();
    } catch (const ParameterTypeException & error) {
      throw exceptions::InvalidParameterTypeException(name_, error.what());
    }
  }

public:
  RCLCPP_SMART_PTR_DEFINITIONS(Parameter)
  Parameter() = default;
  explicit Parameter(const std::string & name)
  : name_(name) {}
  Parameter(const std::string & name, const ParameterValue & value)
  : name_(name), value_(value) {}
  template<class T>
  Parameter(const std::string & name, T value)
  : Parameter(name, ParameterValue(value)) {}

  ParameterType get_type() const {return value_.get_type();}
  std::string get_type_name() const {return to_string(get_type());}
  const std::string & get_name() const {return name_;}
  const ParameterValue & get_parameter_value() const {return value_;}
  rcl_interfaces::msg::ParameterValue get_value_message() const {return value_.to_value_msg();}
  /// The value as a T, or the parameter or its value themselves; a wrong type throws InvalidParameterTypeException.
  template<class T>
  decltype(auto) get_value() const
  {
    if constexpr (std::is_same_v<T, Parameter>) {
      return static_cast<const Parameter &>(*this);
    } else if constexpr (std::is_same_v<T, ParameterValue>) {
      return get_parameter_value();
    } else {
      return checked([this]() -> decltype(auto) {return value_.get<T>();});
    }
  }
  /// The same by the type's number; a wrong one throws ParameterTypeException, as with all below.
  template<ParameterType type>
  decltype(auto) get_value() const {return value_.get<type>();}

  bool as_bool() const {return value_.get<bool>();}
  int64_t as_int() const {return value_.get<int64_t>();}
  double as_double() const {return value_.get<double>();}
  const std::string & as_string() const {return value_.get<std::string>();}
  const std::vector<uint8_t> & as_byte_array() const {return value_.get<std::vector<uint8_t>>();}
  const std::vector<bool> & as_bool_array() const {return value_.get<std::vector<bool>>();}
  const std::vector<int64_t> & as_integer_array() const {return value_.get<std::vector<int64_t>>();}
  const std::vector<double> & as_double_array() const {return value_.get<std::vector<double>>();}
  const std::vector<std::string> & as_string_array() const {return value_.get<std::vector<std::string>>();}
  std::string value_to_string() const {return to_string(value_);}

  static Parameter from_parameter_msg(const rcl_interfaces::msg::Parameter & message)
  {
    return Parameter(message.name, ParameterValue(message.value));
  }
  rcl_interfaces::msg::Parameter to_parameter_msg() const
  {
    rcl_interfaces::msg::Parameter message;
    message.name = name_;
    message.value = value_.to_value_msg();
    return message;
  }
  bool operator==(const Parameter & other) const {return name_ == other.name_ && value_ == other.value_;}
  bool operator!=(const Parameter & other) const {return !(*this == other);}

private:
  std::string name_;
  ParameterValue value_;
};
std::ostream & operator<<(std::ostream & stream, const ParameterValue & value);
std::ostream & operator<<(std::ostream & stream, const Parameter & parameter);
/// A parameter as a part of JSON: "a": {"type": "integer", "value": "1"}
std::string _to_json_dict_entry(const Parameter & parameter);
std::ostream & operator<<(std::ostream & stream, const std::vector<Parameter> & parameters);
}  // namespace rclcpp

namespace std
{
/// A parameter as JSON: {"name": "a", "type": "integer", "value": "1"}
std::string to_string(const rclcpp::Parameter & parameter);
std::string to_string(const std::vector<rclcpp::Parameter> & parameters);
}  // namespace std
