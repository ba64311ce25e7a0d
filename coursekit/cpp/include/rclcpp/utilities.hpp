// init, ok, shutdown and their company.
#pragma once
#include <limits>

#include "rclcpp/context.hpp"
#include "rclcpp/visibility_control.hpp"

namespace rclcpp
{
enum class SignalHandlerOptions {All, SigInt, SigTerm, None};

namespace detail
{
void init(int argc, char const * const * argv, const InitOptions & options, SignalHandlerOptions signals);
/// A program that calls init() is a session's before its main begins: what it prints before the call would come twice.
template<class>
struct Begun {static const bool in_session;};
template<class T>
const bool Begun<T>::in_session = coursekit::begin_in_session();
}  // namespace detail

/// Templates, so that only programs that call them have Begun.
template<class T = void>
void init(
  int argc, char const * const * argv, const InitOptions & options = InitOptions(),
  SignalHandlerOptions signals = SignalHandlerOptions::All)
{
  (void)&detail::Begun<T>::in_session;
  detail::init(argc, argv, options, signals);
}
std::vector<std::string> remove_ros_arguments(int argc, char const * const * argv);
template<class T = void>
std::vector<std::string> init_and_remove_ros_arguments(
  int argc, char const * const * argv, const InitOptions & options = InitOptions())
{
  init<T>(argc, argv, options);
  return remove_ros_arguments(argc, argv);
}
bool install_signal_handlers(SignalHandlerOptions signals = SignalHandlerOptions::All);
bool signal_handlers_installed();
/// The signals that are handled; None where none are.
SignalHandlerOptions get_current_signal_handler_options();
bool uninstall_signal_handlers();
bool ok(Context::SharedPtr context = nullptr);
bool shutdown(Context::SharedPtr context = nullptr, const std::string & reason = "user called rclcpp::shutdown()");
void on_shutdown(std::function<void ()> callback, Context::SharedPtr context = nullptr);
inline const char * get_c_string(const char * text) {return text;}
inline const char * get_c_string(const std::string & text) {return text.c_str();}
inline std::vector<const char *> get_c_vector_string(const std::vector<std::string> & texts)
{
  std::vector<const char *> all;
  for (auto & text : texts) {
    all.push_back(text.c_str());
  }
  return all;
}
template<class T>
bool add_will_overflow(const T x, const T y) {return y > 0 && x > std::numeric_limits<T>::max() - y;}
template<class T>
bool add_will_underflow(const T x, const T y) {return y < 0 && x < std::numeric_limits<T>::min() - y;}
template<class T>
bool sub_will_overflow(const T x, const T y) {return y < 0 && x > std::numeric_limits<T>::max() + y;}
template<class T>
bool sub_will_underflow(const T x, const T y) {return y > 0 && x < std::numeric_limits<T>::min() + y;}
bool sleep_for(const std::chrono::nanoseconds & duration, Context::SharedPtr context = nullptr);
}  // namespace rclcpp
