// What is known of a type while a program is compiled: which kind of interface it is, its names, its size.
#pragma once
#include <string>
#include <type_traits>

#include "coursekit/cdr.hpp"

namespace rosidl_generator_traits
{
template<class T>
struct is_message : coursekit::is_message<T> {};

#define COURSEKIT_TRAIT(name) \
  template<class T> \
  struct name : std::false_type {};
COURSEKIT_TRAIT(is_service)
COURSEKIT_TRAIT(is_service_request)
COURSEKIT_TRAIT(is_service_response)
COURSEKIT_TRAIT(is_action)
COURSEKIT_TRAIT(is_action_goal)
COURSEKIT_TRAIT(is_action_result)
COURSEKIT_TRAIT(is_action_feedback)
#undef COURSEKIT_TRAIT

/// Whether all messages of the type take the same number of bytes; a service does where its two messages do.
template<class T, class = void>
struct has_fixed_size : std::false_type {};
template<class T>
struct has_fixed_size<T, std::enable_if_t<coursekit::is_message<T>::value>> : std::bool_constant<T::coursekit_fixed_size> {};
template<class T>
struct has_fixed_size<T, std::enable_if_t<is_service<T>::value>>
  : std::conjunction<has_fixed_size<typename T::Request>, has_fixed_size<typename T::Response>> {};

/// Whether no message of the type takes more than so many bytes.
template<class T, class = void>
struct has_bounded_size : std::false_type {};
template<class T>
struct has_bounded_size<T, std::enable_if_t<coursekit::is_message<T>::value>>
  : std::bool_constant<T::coursekit_bounded_size> {};
template<class T>
struct has_bounded_size<T, std::enable_if_t<is_service<T>::value>>
  : std::conjunction<has_bounded_size<typename T::Request>, has_bounded_size<typename T::Response>> {};

/// "std_msgs/msg/String"
template<class T>
const char * name() {return T::coursekit_type;}
/// "std_msgs::msg::String"
template<class T>
const char * data_type()
{
  static const std::string text = [] {
      std::string all = T::coursekit_type;
      for (size_t at; (at = all.find('/')) != std::string::npos; ) {
        all.replace(at, 1, "::");
      }
      return all;
    }();
  return text.c_str();
}
}  // namespace rosidl_generator_traits

#define COURSEKIT_IS(trait, Type) \
  template<> \
  struct rosidl_generator_traits::trait<Type> : std::true_type {};
