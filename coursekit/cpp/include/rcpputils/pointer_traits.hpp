// What a pointer, smart or plain, points to.
#pragma once
#include <memory>
#include <type_traits>

namespace rcpputils
{
namespace details
{
template<class T>
struct is_smart_pointer : std::false_type {};
template<class T>
struct is_smart_pointer<std::shared_ptr<T>>: std::true_type {};
template<class T, class D>
struct is_smart_pointer<std::unique_ptr<T, D>>: std::true_type {};
template<class T>
constexpr bool is_smart = is_smart_pointer<std::remove_cv_t<T>>::value;

template<class T, bool = is_smart<T>>
struct pointed : std::remove_pointer<T> {};
template<class T>
struct pointed<T, true>
{
  using type = typename T::element_type;
};
}  // namespace details

template<class T>
struct is_pointer
  : std::bool_constant<std::is_pointer_v<std::remove_reference_t<T>> || details::is_smart<std::remove_reference_t<T>>> {};
template<class T>
struct remove_pointer : details::pointed<std::remove_reference_t<T>> {};
}  // namespace rcpputils
