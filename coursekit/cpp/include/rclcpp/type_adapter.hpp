// Type adaptation: what a program handles, and the message that it stands for.
#pragma once
#include <type_traits>

#include "coursekit/cdr.hpp"

namespace rclcpp
{
/// A program specializes this for its type, with is_specialized, convert_to_ros_message and convert_to_custom.
template<class CustomType, class ROSMessageType = void, class Enable = void>
struct TypeAdapter
{
  using is_specialized = std::false_type;
  using custom_type = CustomType;
  using ros_message_type = CustomType;
};
template<class T>
struct is_type_adapter : std::false_type {};
template<class C, class R>
struct is_type_adapter<TypeAdapter<C, R>> : std::true_type {};

template<class T>
struct ImplicitTypeAdapter
{
  using is_specialized = std::false_type;
};
template<class T, class = void>
struct adapter_of {using type = TypeAdapter<T>;};
template<class T>
struct adapter_of<T, std::enable_if_t<is_type_adapter<T>::value>> {using type = T;};
template<class T>
struct adapter_of<T, std::enable_if_t<!is_type_adapter<T>::value && ImplicitTypeAdapter<T>::is_specialized::value>>
{
  using type = ImplicitTypeAdapter<T>;
};
#define RCLCPP_USING_CUSTOM_TYPE_AS_ROS_MESSAGE_TYPE(CustomType, ROSMessageType) \
  template<> \
  struct rclcpp::ImplicitTypeAdapter<CustomType> : public rclcpp::TypeAdapter<CustomType, ROSMessageType> {}

template<class T>
using Adapter = typename adapter_of<T>::type;
template<class T>
using CustomOf = typename Adapter<T>::custom_type;
template<class T>
using MessageOf = typename Adapter<T>::ros_message_type;
template<class T>
constexpr bool is_adapted = !std::is_same_v<CustomOf<T>, MessageOf<T>>;
template<class C>
struct adapt_type
{
  template<class R>
  using as = TypeAdapter<C, R>;
};

/// The bytes of a custom object: those of the message that it stands for.
template<class T>
std::string custom_to_cdr(const CustomOf<T> & custom)
{
  if constexpr (is_adapted<T>) {
    MessageOf<T> message;
    Adapter<T>::convert_to_ros_message(custom, message);
    return coursekit::to_cdr(message);
  } else {
    return coursekit::to_cdr(custom);
  }
}
}  // namespace rclcpp
