// What a parameter's value has to be, under the names that files for generate_parameter_library use.
#pragma once
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "rcl_interfaces/msg/set_parameters_result.hpp"
#include "rclcpp/parameter.hpp"
#include "rsl/algorithm.hpp"
#include "rsl/static_string.hpp"
#include "rsl/static_vector.hpp"
#include "tl_expected/expected.hpp"

namespace rsl
{
using Result = tl::expected<void, std::string>;

namespace detail
{
inline void write(std::ostream & out, bool value) {out << (value ? "true" : "false");}
template<class T>
void write(std::ostream & out, const T & value) {out << value;}
template<class T>
void write(std::ostream & out, const std::vector<T> & values)
{
  for (size_t i = 0; i < values.size(); ++i) {
    out << (i ? ", " : "");
    write(out, static_cast<T>(values[i]));
  }
}
/// Nothing where it holds, else a sentence of these pieces.
template<class ... Pieces>
Result check(bool holds, const Pieces & ... pieces)
{
  if (holds) {
    return {};
  }
  std::ostringstream out;
  (write(out, pieces), ...);
  return tl::make_unexpected(out.str());
}
/// How many characters a text has, or elements an array.
template<class T>
size_t size_of(const rclcpp::Parameter & parameter)
{
  bool text = parameter.get_type() == rclcpp::ParameterType::PARAMETER_STRING;
  return text ? parameter.as_string().size() : parameter.get_value<std::vector<T>>().size();
}
template<class T, class F>
Result size_is(const rclcpp::Parameter & parameter, size_t size, const char * words, F compare)
{
  size_t has = size_of<T>(parameter);
  return check(compare(has, size), "Length of parameter '", parameter.get_name(), "' is '", has, "' but must be ", words, " '", size, "'");
}
template<class T, class F>
Result value_is(const rclcpp::Parameter & parameter, const T & other, const char * words, F compare)
{
  T value = parameter.get_value<T>();
  return check(
    compare(value, other), "Parameter '", parameter.get_name(), "' with the value '", value, "' must be ", words, " '", other, "'");
}
/// Check the elements of an array one by one, with these pieces behind "Value 'x' in parameter 'y' must be ".
template<class T, class F, class ... Pieces>
Result each_is(const rclcpp::Parameter & parameter, F holds, const Pieces & ... pieces)
{
  for (T value : parameter.get_value<std::vector<T>>()) {
    if (auto result = check(holds(value), "Value '", value, "' in parameter '", parameter.get_name(), "' must be ", pieces ...); !result) {
      return result;
    }
  }
  return {};
}
}  // namespace detail

// -- of arrays and texts

template<class T>
Result unique(const rclcpp::Parameter & parameter)
{
  return detail::check(
    is_unique(parameter.get_value<std::vector<T>>()), "Parameter '", parameter.get_name(), "' must only contain unique values");
}
template<class T>
Result subset_of(const rclcpp::Parameter & parameter, const std::vector<T> & valid)
{
  for (T value : parameter.get_value<std::vector<T>>()) {
    if (!contains(valid, value)) {
      return detail::check(false, "Entry '", value, "' in parameter '", parameter.get_name(), "' is not in the set '{", valid, "}'");
    }
  }
  return {};
}
template<class T>
Result fixed_size(const rclcpp::Parameter & parameter, size_t size)
{
  return detail::size_is<T>(parameter, size, "equal to", std::equal_to<>());
}
template<class T>
Result size_gt(const rclcpp::Parameter & parameter, size_t size)
{
  return detail::size_is<T>(parameter, size, "greater than", std::greater<>());
}
template<class T>
Result size_lt(const rclcpp::Parameter & parameter, size_t size)
{
  return detail::size_is<T>(parameter, size, "less than", std::less<>());
}
template<class T>
Result not_empty(const rclcpp::Parameter & parameter)
{
  return detail::check(detail::size_of<T>(parameter) > 0, "Parameter '", parameter.get_name(), "' cannot be empty");
}
template<class T>
Result element_bounds(const rclcpp::Parameter & parameter, const T & lower, const T & upper)
{
  auto inside = [&](const T & value) {return !(value < lower || value > upper);};
  return detail::each_is<T>(parameter, inside, "within bounds '[", lower, ", ", upper, "]'");
}
template<class T>
Result lower_element_bounds(const rclcpp::Parameter & parameter, const T & lower)
{
  return detail::each_is<T>(parameter, [&](const T & value) {return !(value < lower);}, "above lower bound of '", lower, "'");
}
template<class T>
Result upper_element_bounds(const rclcpp::Parameter & parameter, const T & upper)
{
  return detail::each_is<T>(parameter, [&](const T & value) {return !(value > upper);}, "below upper bound of '", upper, "'");
}

// -- of single values

template<class T>
Result bounds(const rclcpp::Parameter & parameter, const T & lower, const T & upper)
{
  T value = parameter.get_value<T>();
  return detail::check(
    !(value < lower || value > upper), "Parameter '", parameter.get_name(), "' with the value '", value, "' must be within bounds '[",
    lower, ", ", upper, "]'");
}
template<class T>
Result lower_bounds(const rclcpp::Parameter & parameter, const T & value)
{
  return detail::value_is(parameter, value, "above lower bound of", std::greater_equal<>());
}
template<class T>
Result upper_bounds(const rclcpp::Parameter & parameter, const T & value)
{
  return detail::value_is(parameter, value, "below upper bound of", std::less_equal<>());
}
template<class T>
Result lt(const rclcpp::Parameter & parameter, const T & value)
{
  return detail::value_is(parameter, value, "less than", std::less<>());
}
template<class T>
Result gt(const rclcpp::Parameter & parameter, const T & value)
{
  return detail::value_is(parameter, value, "greater than", std::greater<>());
}
template<class T>
Result lt_eq(const rclcpp::Parameter & parameter, const T & value)
{
  return detail::value_is(parameter, value, "less than or equal to", std::less_equal<>());
}
template<class T>
Result gt_eq(const rclcpp::Parameter & parameter, const T & value)
{
  return detail::value_is(parameter, value, "greater than or equal to", std::greater_equal<>());
}
template<class T>
Result one_of(const rclcpp::Parameter & parameter, const std::vector<T> & valid)
{
  T value = parameter.get_value<T>();
  return detail::check(
    contains(valid, value), "Parameter '", parameter.get_name(), "' with the value '", value, "' is not in the set '{", valid, "}'");
}

inline rcl_interfaces::msg::SetParametersResult to_parameter_result_msg(const Result & result)
{
  rcl_interfaces::msg::SetParametersResult message;
  message.successful = result.has_value();
  message.reason = result ? "" : result.error();
  return message;
}
}  // namespace rsl
