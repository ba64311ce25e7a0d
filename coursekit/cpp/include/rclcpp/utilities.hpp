// init, ok, shutdown and their company.
#pragma once
#include "rclcpp/context.hpp"
#include "rclcpp/visibility_control.hpp"

namespace rclcpp
{
enum class SignalHandlerOptions {All, SigInt, SigTerm, None};

void init(
  int argc, char const * const * argv, const InitOptions & options = InitOptions(),
  SignalHandlerOptions signals = SignalHandlerOptions::All);
std::vector<std::string> init_and_remove_ros_arguments(
  int argc, char const * const * argv, const InitOptions & options = InitOptions());
std::vector<std::string> remove_ros_arguments(int argc, char const * const * argv);
bool install_signal_handlers(SignalHandlerOptions signals = SignalHandlerOptions::All);
bool signal_handlers_installed();
bool uninstall_signal_handlers();
bool ok(Context::SharedPtr context = nullptr);
bool shutdown(Context::SharedPtr context = nullptr, const std::string & reason = "user called rclcpp::shutdown()");
void on_shutdown(std::function<void ()> callback, Context::SharedPtr context = nullptr);
inline const char * get_c_string(const char * text) {return text;}
inline const char * get_c_string(const std::string & text) {return text.c_str();}
bool sleep_for(const std::chrono::nanoseconds & duration, Context::SharedPtr context = nullptr);
}  // namespace rclcpp
