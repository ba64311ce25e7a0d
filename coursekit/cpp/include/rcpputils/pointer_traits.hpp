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
}  // namespace details

template<class T>
struct is_pointer
  : std::bool_constant<std::is_pointer_v<std::remove_reference_t<T>> ||
    details::is_smart_pointer<std::remove_cv_t<std::remove_reference_t<T>>>::value> {};
template<class T>
struct remove_pointer
{
private:
  using Plain = std::remove_cv_t<std::remove_reference_t<T>>;
  template<class P>
  static auto pointed(int) -> typename P::element_type;
  template<class P>
  static auto pointed(long) -> std::remove_pointer_t<P>;  // NOLINT

public:
  using type = decltype(pointed<Plain>(0));
};
}  // namespace rcpputils
