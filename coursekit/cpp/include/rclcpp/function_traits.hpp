// What a callable takes and returns, told by its type: lambdas, functions, methods, std::function, std::bind.
#pragma once
#include <functional>
#include <memory>
#include <tuple>

namespace rclcpp::function_traits
{
template<class T>
struct tuple_tail;
template<class Head, class ... Tail>
struct tuple_tail<std::tuple<Head, Tail ...>> {using type = std::tuple<Tail ...>;};

/// A functor: its call operator without the object that it is called on.
template<class F>
struct function_traits
{
private:
  using Call = function_traits<decltype( &F::operator())>;

public:
  using arguments = typename tuple_tail<typename Call::arguments>::type;
  using return_type = typename Call::return_type;
  static constexpr std::size_t arity = std::tuple_size_v<arguments>;
  template<std::size_t N>
  using argument_type = std::tuple_element_t<N, arguments>;
};
template<class R, class ... A>
struct function_traits<R(A ...)>
{
  using arguments = std::tuple<A ...>;
  using return_type = R;
  static constexpr std::size_t arity = sizeof...(A);
  template<std::size_t N>
  using argument_type = std::tuple_element_t<N, arguments>;
};
template<class R, class ... A>
struct function_traits<R (*)(A ...)>: function_traits<R(A ...)> {};
template<class C, class R, class ... A>
struct function_traits<R (C::*)(A ...)>: function_traits<R(C &, A ...)> {};
template<class C, class R, class ... A>
struct function_traits<R (C::*)(A ...) const>: function_traits<R(const C &, A ...)> {};
template<class F>
struct function_traits<F &>: function_traits<F> {};
template<class F>
struct function_traits<F &&>: function_traits<F> {};
#if defined(__GLIBCXX__)
template<class C, class R, class ... A, class ... Bound>
struct function_traits<std::_Bind<R (C::*(Bound ...))(A ...)>>: function_traits<R(A ...)> {};
template<class C, class R, class ... A, class ... Bound>
struct function_traits<std::_Bind<R (C::*(Bound ...))(A ...) const>>: function_traits<R(A ...)> {};
template<class R, class ... A, class ... Bound>
struct function_traits<std::_Bind<R (*(Bound ...))(A ...)>>: function_traits<R(A ...)> {};
#endif

template<std::size_t Arity, class F>
struct arity_comparator : std::bool_constant<function_traits<F>::arity == Arity> {};
template<class F, class ... A>
struct check_arguments : std::is_same<typename function_traits<F>::arguments, std::tuple<A ...>> {};
template<class F, class G>
struct same_arguments
  : std::is_same<typename function_traits<F>::arguments, typename function_traits<G>::arguments> {};

/// The same call as a std::function.
template<class F>
struct as_std_function_helper;
template<class ... A>
struct as_std_function_helper<std::tuple<A ...>>
{
  template<class R>
  using type = std::function<R(A ...)>;
};
template<class F>
struct as_std_function
{
  using type = typename as_std_function_helper<typename function_traits<F>::arguments>::template type<
    typename function_traits<F>::return_type>;
};
}  // namespace rclcpp::function_traits
