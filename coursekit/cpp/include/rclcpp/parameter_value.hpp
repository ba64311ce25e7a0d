// The values of parameters: of one of nine types, or not set.
#pragma once
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

#include "rcl_interfaces/msg/parameter_type.hpp"
#include "rcl_interfaces/msg/parameter_value.hpp"
#include "rclcpp/exceptions.hpp"

namespace rclcpp
{
enum ParameterType : uint8_t
{
  PARAMETER_NOT_SET, PARAMETER_BOOL, PARAMETER_INTEGER, PARAMETER_DOUBLE, PARAMETER_STRING, PARAMETER_BYTE_ARRAY,
  PARAMETER_BOOL_ARRAY, PARAMETER_INTEGER_ARRAY, PARAMETER_DOUBLE_ARRAY, PARAMETER_STRING_ARRAY
};
std::string to_string(ParameterType type);
std::ostream & operator<<(std::ostream & stream, ParameterType type);
/// Somebody asked for a value of another type.
class ParameterTypeException : public std::runtime_error
{
public:
  ParameterTypeException(ParameterType expected, ParameterType actual)
  : std::runtime_error("expected [" + to_string(expected) + "] got [" + to_string(actual) + "]") {}
};

namespace detail
{
/// The type of parameter for a C++ type, and its field of the message.
template<class T, class = void>
struct ParameterKind;
#define COURSEKIT_PARAMETER(Kind, field) \
  static constexpr ParameterType type = Kind; \
  static auto & of(rcl_interfaces::msg::ParameterValue & message) {return message.field;} \
  static const auto & of(const rcl_interfaces::msg::ParameterValue & message) {return message.field;}
#define COURSEKIT_PARAMETER_KIND(T, Kind, field) \
  template<> \
  struct ParameterKind<T> {COURSEKIT_PARAMETER(Kind, field)};
COURSEKIT_PARAMETER_KIND(bool, PARAMETER_BOOL, bool_value)
COURSEKIT_PARAMETER_KIND(std::string, PARAMETER_STRING, string_value)
COURSEKIT_PARAMETER_KIND(const char *, PARAMETER_STRING, string_value)
COURSEKIT_PARAMETER_KIND(std::vector<uint8_t>, PARAMETER_BYTE_ARRAY, byte_array_value)
COURSEKIT_PARAMETER_KIND(std::vector<bool>, PARAMETER_BOOL_ARRAY, bool_array_value)
COURSEKIT_PARAMETER_KIND(std::vector<int64_t>, PARAMETER_INTEGER_ARRAY, integer_array_value)
COURSEKIT_PARAMETER_KIND(std::vector<int>, PARAMETER_INTEGER_ARRAY, integer_array_value)
COURSEKIT_PARAMETER_KIND(std::vector<double>, PARAMETER_DOUBLE_ARRAY, double_array_value)
COURSEKIT_PARAMETER_KIND(std::vector<float>, PARAMETER_DOUBLE_ARRAY, double_array_value)
COURSEKIT_PARAMETER_KIND(std::vector<std::string>, PARAMETER_STRING_ARRAY, string_array_value)
template<class T>
struct ParameterKind<T, std::enable_if_t<
    (std::is_integral_v<T> && !std::is_same_v<T, bool>) || (std::is_enum_v<T> && std::is_convertible_v<T, int64_t>)>>
{
  COURSEKIT_PARAMETER(PARAMETER_INTEGER, integer_value)
};
template<class T>
struct ParameterKind<T, std::enable_if_t<std::is_floating_point_v<T>>>
{
  COURSEKIT_PARAMETER(PARAMETER_DOUBLE, double_value)
};
/// The C++ type that `get<PARAMETER_...>()` and `as_...()` give.
template<ParameterType type>
struct TypeOf;
#define COURSEKIT_TYPE_OF(Kind, ...) \
  template<> \
  struct TypeOf<Kind> {using type = __VA_ARGS__;};
COURSEKIT_TYPE_OF(PARAMETER_BOOL, bool)
COURSEKIT_TYPE_OF(PARAMETER_INTEGER, int64_t)
COURSEKIT_TYPE_OF(PARAMETER_DOUBLE, double)
COURSEKIT_TYPE_OF(PARAMETER_STRING, std::string)
COURSEKIT_TYPE_OF(PARAMETER_BYTE_ARRAY, std::vector<uint8_t>)
COURSEKIT_TYPE_OF(PARAMETER_BOOL_ARRAY, std::vector<bool>)
COURSEKIT_TYPE_OF(PARAMETER_INTEGER_ARRAY, std::vector<int64_t>)
COURSEKIT_TYPE_OF(PARAMETER_DOUBLE_ARRAY, std::vector<double>)
COURSEKIT_TYPE_OF(PARAMETER_STRING_ARRAY, std::vector<std::string>)
}  // namespace detail

class ParameterValue
{
public:
  ParameterValue() = default;
  explicit ParameterValue(const rcl_interfaces::msg::ParameterValue & message)
  : message_(message) {}
  explicit ParameterValue(const char * text)
  : ParameterValue(std::string(text)) {}
  template<class T, class Kind = detail::ParameterKind<std::decay_t<T>>, auto type = Kind::type>
  explicit ParameterValue(const T & value)
  {
    message_.type = type;
    if constexpr (type >= PARAMETER_BYTE_ARRAY) {
      Kind::of(message_).assign(value.begin(), value.end());
    } else {
      Kind::of(message_) = value;
    }
  }
  ParameterType get_type() const {return static_cast<ParameterType>(message_.type);}
  const rcl_interfaces::msg::ParameterValue & to_value_msg() const {return message_;}

  /// The value as a T; throws ParameterTypeException where it is of another type.
  template<class T>
  decltype(auto) get() const
  {
    using Kind = detail::ParameterKind<std::decay_t<T>>;
    using Field = std::decay_t<decltype(Kind::of(message_))>;
    if (get_type() != Kind::type) {
      throw ParameterTypeException(Kind::type, get_type());
    }
    if constexpr (std::is_same_v<Field, std::decay_t<T>>) {
      return Kind::of(message_);
    } else if constexpr (Kind::type >= PARAMETER_BYTE_ARRAY) {
      return T(Kind::of(message_).begin(), Kind::of(message_).end());
    } else {
      return static_cast<T>(Kind::of(message_));
    }
  }
  template<ParameterType type>
  decltype(auto) get() const {return get<typename detail::TypeOf<type>::type>();}
  bool operator==(const ParameterValue & other) const {return message_ == other.message_;}
  bool operator!=(const ParameterValue & other) const {return !(message_ == other.message_);}

private:
  rcl_interfaces::msg::ParameterValue message_;
};
std::string to_string(const ParameterValue & value);
}  // namespace rclcpp
