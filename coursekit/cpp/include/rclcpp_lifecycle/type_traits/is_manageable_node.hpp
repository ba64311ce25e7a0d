// Whether a type can be managed: activated and deactivated.
#pragma once
#include <type_traits>
#include <utility>

template<class T, class = void>
struct has_on_activate : std::false_type {};
template<class T>
struct has_on_activate<T, std::void_t<decltype(std::declval<T &>().on_activate())>>: std::true_type {};
template<class T, class = void>
struct has_on_deactivate : std::false_type {};
template<class T>
struct has_on_deactivate<T, std::void_t<decltype(std::declval<T &>().on_deactivate())>>: std::true_type {};
template<class T, class = void>
struct is_manageable_node : std::false_type {};
template<class T>
struct is_manageable_node<T, std::enable_if_t<has_on_activate<T>::value && has_on_deactivate<T>::value>>: std::true_type {};
