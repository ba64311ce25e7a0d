// A value, or why there is none.
#pragma once
#include <exception>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

namespace tl
{
template<class E>
class unexpected
{
public:
  explicit unexpected(E error)
  : error_(std::move(error)) {}
  const E & value() const & {return error_;}
  E & value() & {return error_;}
  E && value() && {return std::move(error_);}

private:
  E error_;
};

template<class E>
unexpected(E)->unexpected<E>;

template<class E>
unexpected<std::decay_t<E>> make_unexpected(E && error) {return unexpected<std::decay_t<E>>(std::forward<E>(error));}

template<class E>
class bad_expected_access : public std::exception
{
public:
  explicit bad_expected_access(E error)
  : error_(std::move(error)) {}
  const char * what() const noexcept override {return "Bad expected access";}
  const E & error() const & {return error_;}

private:
  E error_;
};

template<class T, class E>
class expected
{
public:
  using value_type = T;
  using error_type = E;
  using unexpected_type = unexpected<E>;

  template<class V = T, class = std::enable_if_t<std::is_default_constructible_v<V>>>
  expected()
  : is_(std::in_place_index<0>) {}
  template<class V = T, class = std::enable_if_t<std::is_constructible_v<T, V &&> && !std::is_base_of_v<expected, std::decay_t<V>>>>
  expected(V && value)
  : is_(std::in_place_index<0>, std::forward<V>(value)) {}
  template<class G>
  expected(unexpected<G> error)
  : is_(std::in_place_index<1>, std::move(error).value()) {}

  bool has_value() const {return is_.index() == 0;}
  explicit operator bool() const {return has_value();}
  const T & value() const &
  {
    check();
    return **this;
  }
  T & value() &
  {
    check();
    return **this;
  }
  T && value() &&
  {
    check();
    return std::move(**this);
  }
  template<class U>
  T value_or(U && other) const {return has_value() ? **this : static_cast<T>(std::forward<U>(other));}
  const E & error() const & {return *std::get_if<1>(&is_);}
  E & error() & {return *std::get_if<1>(&is_);}
  const T & operator*() const & {return *std::get_if<0>(&is_);}
  T & operator*() & {return *std::get_if<0>(&is_);}
  const T * operator->() const {return std::get_if<0>(&is_);}
  T * operator->() {return std::get_if<0>(&is_);}

private:
  void check() const
  {
    if (!has_value()) {
      throw bad_expected_access<E>(error());
    }
  }

  std::variant<T, E> is_;
};

/// That something was done, or why not.
template<class E>
class expected<void, E>
{
public:
  using value_type = void;
  using error_type = E;
  using unexpected_type = unexpected<E>;

  expected() = default;
  template<class G>
  expected(unexpected<G> error)
  : error_(std::in_place, std::move(error).value()) {}

  bool has_value() const {return !error_;}
  explicit operator bool() const {return has_value();}
  void value() const
  {
    if (error_) {
      throw bad_expected_access<E>(*error_);
    }
  }
  void operator*() const {}
  const E & error() const & {return *error_;}
  E & error() & {return *error_;}

private:
  std::optional<E> error_;
};
}  // namespace tl
