// A value of any type; numbers and texts come out as another type where nothing is lost.
#pragma once
#include <any>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "behaviortree_cpp_v3/utils/demangle_util.h"
#include "behaviortree_cpp_v3/utils/string_view.hpp"

namespace BT
{
class Any
{
  template<class T>
  static constexpr bool is_text_v = std::is_same_v<T, std::string> || std::is_same_v<T, nonstd::string_view> ||
    std::is_convertible_v<T, const char *>;

public:
  Any() = default;
  template<class T, class = std::enable_if_t<!std::is_base_of_v<Any, T>>>
  explicit Any(const T & value)
  : value_(kept(value)), type_(is_text_v<T> ? &typeid(std::string) : &typeid(T)) {}

  bool isNumber() const {return is<int64_t>() || is<uint64_t>() || is<double>();}
  bool isString() const {return is<std::string>();}
  bool empty() const noexcept {return !value_.has_value();}
  /// The type that it was made of, and the one that it is kept as: int64_t, uint64_t or double for a number.
  const std::type_info & type() const noexcept {return *type_;}
  const std::type_info & castedType() const noexcept {return value_.type();}

  /// Throws std::runtime_error where there is no such value, or it does not fit.
  template<class T>
  T cast() const
  {
    static_assert(!std::is_reference_v<T>, "an Any gives values, not references");
    using Plain = std::remove_cv_t<T>;
    if (empty()) {
      throw std::runtime_error("Any::cast failed because it is empty");
    }
    if (is<T>()) {
      return std::any_cast<T>(value_);
    }
    if constexpr (std::is_same_v<Plain, std::string>) {
      return number_as_text(typeid(T));
    } else if constexpr (std::is_same_v<Plain, bool>) {
      return as_bool();
    } else if constexpr (std::is_enum_v<T>) {
      return static_cast<T>(as_integer(typeid(T)));
    } else if constexpr (std::is_arithmetic_v<T>) {
      return as_number<Plain>();
    } else {
      fail(typeid(T));
    }
  }

private:
  template<class T>
  bool is() const {return value_.type() == typeid(T);}
  template<class T>
  static auto kept(const T & value)
  {
    if constexpr (is_text_v<T>) {
      return std::string(nonstd::string_view(value));
    } else if constexpr (std::is_floating_point_v<T>) {
      return static_cast<double>(value);
    } else if constexpr (std::is_integral_v<T> && std::is_unsigned_v<T> && sizeof(T) == sizeof(uint64_t)) {
      return static_cast<uint64_t>(value);
    } else if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) {
      return static_cast<int64_t>(value);
    } else {
      return value;
    }
  }
  template<class T>
  T as_number() const
  {
    if (is<int64_t>()) {
      return fitting<T>(std::any_cast<int64_t>(value_));
    }
    if (is<uint64_t>()) {
      return fitting<T>(std::any_cast<uint64_t>(value_));
    }
    return is<double>() ? fitting<T>(std::any_cast<double>(value_)) : throw failure(typeid(T));
  }
  template<class T, class From>
  static T fitting(From number)
  {
    const T as = static_cast<T>(number);
    if constexpr (!(std::is_floating_point_v<T> && std::is_floating_point_v<From>)) {
      if (static_cast<From>(as) != number || (as < T(0)) != (number < From(0))) {
        throw std::runtime_error(
                std::is_floating_point_v<From> ? "Floating point truncated" : "Value outside the numerical limits.");
      }
    }
    return as;
  }
  bool as_bool() const;
  int64_t as_integer(const std::type_info & as) const;
  std::string number_as_text(const std::type_info & as) const;
  std::runtime_error failure(const std::type_info & as) const;
  [[noreturn]] void fail(const std::type_info & as) const {throw failure(as);}

  std::any value_;
  const std::type_info * type_ = &typeid(void);
};
}  // namespace BT
