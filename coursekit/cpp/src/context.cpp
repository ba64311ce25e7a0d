// init, ok, shutdown, signals, clocks, loggers: what belongs to the whole program.
#include <stdarg.h>
#include <stdio.h>

#include <algorithm>
#include <atomic>

#include "rclcpp/rclcpp.hpp"
#include "rcutils/logging.h"

namespace rclcpp
{
namespace
{
/// Throw about a name; the session's text has the reason, the name in a line of its own, and below it an arrow.
template<class Error>
[[noreturn]] void throw_about_name(const std::string & text)
{
  const size_t reason = text.find(": ") + 2, name = text.find(":\n  '", reason), end = text.rfind("'\n");
  if (name == std::string::npos || end == std::string::npos) {
    throw Error("", text.c_str(), 0);
  }
  const size_t arrow = text.find('^', end) - end - 5;
  throw Error(text.substr(name + 5, end - name - 5).c_str(), text.substr(reason, name - reason).c_str(), arrow);
}
/// Throw what rclcpp throws for a refusal of the session.
[[noreturn]] void rethrow(const coursekit::Refused & refusal)
{
  const std::string & kind = refusal.kind;
  const std::string text = refusal.what();
#define COURSEKIT_THROW(Name) \
  if (kind == #Name) { \
    throw exceptions::Name(text); \
  }
#define COURSEKIT_THROW_ABOUT_NAME(Name) \
  if (kind == #Name) { \
    throw_about_name<exceptions::Name>(text); \
  }
  COURSEKIT_THROW_ABOUT_NAME(InvalidNodeNameError)
  COURSEKIT_THROW_ABOUT_NAME(InvalidNamespaceError)
  COURSEKIT_THROW_ABOUT_NAME(InvalidTopicNameError)
  COURSEKIT_THROW_ABOUT_NAME(InvalidServiceNameError)
  COURSEKIT_THROW(InvalidNodeError)
  COURSEKIT_THROW(UnsupportedEventTypeException)
  COURSEKIT_THROW(ParameterAlreadyDeclaredException)
  COURSEKIT_THROW(ParameterNotDeclaredException)
  COURSEKIT_THROW(ParameterUninitializedException)
  COURSEKIT_THROW(ParameterImmutableException)
  COURSEKIT_THROW(ParameterModifiedInCallbackException)
  COURSEKIT_THROW(InvalidParametersException)
  COURSEKIT_THROW(InvalidParameterValueException)
  COURSEKIT_THROW(InvalidParameterTypeException)
  COURSEKIT_THROW(InvalidQosOverridesException)
  COURSEKIT_THROW(RCLInvalidROSArgsError)
  if (kind == "runtime_error") {
    throw std::runtime_error(text);
  }
  throw exceptions::RCLError(text);
}
std::atomic<bool> g_handles_signals{false};
std::atomic<SignalHandlerOptions> g_signals{SignalHandlerOptions::None};
std::atomic<int64_t> g_contexts{0};
}  // namespace
static void forget_log_levels();

Unpacker ask(const char * what, const Packer & with)
{
  try {
    return coursekit::request(what, with);
  } catch (const coursekit::Refused & refusal) {
    rethrow(refusal);
  }
}

void exceptions::throw_from_rcl_error(
  int ret, const std::string & prefix, const rcl_error_state_t * error_state, void (* reset_error)())
{
  if (ret == RCL_RET_OK) {
    throw std::invalid_argument("ret is RCL_RET_OK");
  }
  auto state = error_state ? error_state : rcl_get_error_state();
  if (!state) {
    throw std::runtime_error("rcl error state is not set");
  }
  const std::string text = (prefix.empty() ? "" : prefix + ": ") + state->message;
  if (reset_error) {
    reset_error();
  }
  if (ret == RCL_RET_INVALID_ARGUMENT) {
    throw RCLInvalidArgument(text, ret);
  }
  throw RCLError(text, ret);
}

// -- the context

Context::Context()
: Context(++g_contexts) {}
void Context::init(int argc, char const * const * argv, const InitOptions & options)
{
  if (valid_) {
    throw ContextAlreadyInitialized();
  }
  Packer with = Packer{}.i(number_).i(options.domain_id_).i(argc);
  for (int i = 0; i < argc; ++i) {
    with.s(argv[i]);
  }
  ask("init", with);
  forget_log_levels();
  options_ = options;
  valid_ = true;
}
bool Context::is_valid() const
{
  coursekit::poll();
  return valid_ && !(coursekit::stopping() && g_handles_signals && options_.shutdown_on_signal);
}
bool Context::shutdown(const std::string & reason)
{
  if (!valid_) {
    return false;
  }
  call(before_);
  valid_ = false;
  reason_ = reason;
  ask("shutdown", Packer{}.i(number_));
  call(after_);
  return true;
}
void Context::call(const Callbacks & callbacks)
{
  for (auto & callback : callbacks_in(callbacks)) {
    callback();
  }
}
std::vector<Context::OnShutdownCallback> Context::callbacks_in(const Callbacks & callbacks) const
{
  std::lock_guard<std::mutex> hold(lock_);
  std::vector<OnShutdownCallback> all;
  for (auto & entry : callbacks) {
    all.push_back(entry.second);
  }
  return all;
}
Context::OnShutdownCallback Context::on_shutdown(OnShutdownCallback callback)
{
  add_on_shutdown_callback(callback);
  return callback;
}
OnShutdownCallbackHandle Context::add_on_shutdown_callback(OnShutdownCallback callback)
{
  std::lock_guard<std::mutex> hold(lock_);
  after_.emplace_back(next_, std::move(callback));
  return {next_++};
}
PreShutdownCallbackHandle Context::add_pre_shutdown_callback(OnShutdownCallback callback)
{
  std::lock_guard<std::mutex> hold(lock_);
  before_.emplace_back(next_, std::move(callback));
  return {next_++};
}
bool Context::remove(Callbacks & callbacks, const ShutdownCallbackHandle & handle)
{
  std::lock_guard<std::mutex> hold(lock_);
  auto is_it = [&](auto & entry) {return entry.first == handle.number;};
  auto found = std::find_if(callbacks.begin(), callbacks.end(), is_it);
  if (found == callbacks.end()) {
    return false;
  }
  callbacks.erase(found);
  return true;
}
bool Context::remove_on_shutdown_callback(const OnShutdownCallbackHandle & handle) {return remove(after_, handle);}
bool Context::remove_pre_shutdown_callback(const PreShutdownCallbackHandle & handle) {return remove(before_, handle);}
size_t Context::get_domain_id() const
{
  if (!valid_) {
    throw exceptions::RCLError("failed to get domain id from context: context is not initialized");
  }
  return static_cast<size_t>(ask("domain", Packer{}.i(number_)).i());
}
bool Context::sleep_for(const std::chrono::nanoseconds & duration)
{
  return coursekit::sleep_for(duration.count(), number_) && is_valid();
}
contexts::DefaultContext::SharedPtr contexts::get_global_default_context()
{
  static auto * context = new DefaultContext::SharedPtr(new DefaultContext(0));
  return *context;
}

// -- the program

void detail::init(int argc, char const * const * argv, const InitOptions & options, SignalHandlerOptions signals)
{
  contexts::get_global_default_context()->init(argc, argv, options);
  install_signal_handlers(signals);
}
std::vector<std::string> remove_ros_arguments(int argc, char const * const * argv)
{
  std::vector<std::string> rest;
  bool ros = false;
  for (int i = 0; i < argc; ++i) {
    std::string word = argv[i];
    if (word == "--ros-args") {
      ros = true;
    } else if (ros && word == "--") {
      ros = false;
    } else if (!ros) {
      rest.push_back(word);
    }
  }
  return rest;
}
bool install_signal_handlers(SignalHandlerOptions signals)
{
  if (signals == SignalHandlerOptions::None || g_handles_signals.exchange(true)) {
    return false;
  }
  g_signals = signals;
  bool all = signals == SignalHandlerOptions::All;
  bool interrupt = all || signals == SignalHandlerOptions::SigInt, terminate = all || signals == SignalHandlerOptions::SigTerm;
  coursekit::catch_signals(interrupt, terminate);
  coursekit::note("catch_signals", Packer{}.i(interrupt).i(terminate));
  return true;
}
bool signal_handlers_installed() {return g_handles_signals;}
SignalHandlerOptions get_current_signal_handler_options()
{
  return g_handles_signals ? g_signals.load() : SignalHandlerOptions::None;
}
bool uninstall_signal_handlers()
{
  if (!g_handles_signals.exchange(false)) {
    return false;
  }
  coursekit::release_signals();
  coursekit::note("catch_signals", Packer{}.i(false).i(false));
  return true;
}
namespace
{
Context::SharedPtr given_or_default(Context::SharedPtr context)
{
  return context ? context : contexts::get_global_default_context();
}
}  // namespace
bool ok(Context::SharedPtr context) {return given_or_default(context)->is_valid();}
bool shutdown(Context::SharedPtr context, const std::string & reason)
{
  bool ended = given_or_default(context)->shutdown(reason);
  uninstall_signal_handlers();
  return ended;
}
void on_shutdown(std::function<void ()> callback, Context::SharedPtr context)
{
  given_or_default(context)->on_shutdown(std::move(callback));
}
bool sleep_for(const std::chrono::nanoseconds & duration, Context::SharedPtr context)
{
  return given_or_default(context)->sleep_for(duration);
}

// -- clocks

bool Clock::simulated() const {return handle().type == RCL_ROS_TIME && node() && coursekit::simulated_time();}
bool Clock::ros_time_is_active() const
{
  return handle().overridden || (simulated() && ask("ros_time_active", Packer{}.i(node())).i());
}
Time Clock::now() const
{
  if (handle().overridden) {
    return Time(handle().time, handle().type);
  }
  if (simulated()) {
    return Time(ask("ros_now", Packer{}.i(node())).i(), handle().type);
  }
  return Time(handle().type == RCL_STEADY_TIME ? coursekit::steady_now() : coursekit::system_now(), handle().type);
}
bool Clock::sleep_until(Time until, Context::SharedPtr context)
{
  if (until.get_clock_type() != handle().type) {
    throw std::runtime_error("until's clock type does not match this clock's type");
  }
  return sleep_for(until - now(), context);
}
bool Clock::sleep_by_override(const Time & until, const Context::SharedPtr & context) const
{
  while (handle().overridden && now() < until) {
    if (!context->sleep_for(std::chrono::milliseconds(1))) {
      return false;
    }
  }
  return handle().overridden;
}
bool Clock::sleep_for(Duration duration, Context::SharedPtr context)
{
  if (!context || !context->is_valid()) {
    throw std::runtime_error("context cannot be slept with because it's invalid");
  }
  if (handle().overridden) {
    return sleep_by_override(now() + duration, context);
  }
  if (handle().type == RCL_ROS_TIME && node()) {  // also where it does not follow /clock yet: who sleeps wakes when it does
    return ask("ros_sleep", Packer{}.i(node()).i(duration.nanoseconds())).i();
  }
  return context->sleep_for(std::chrono::nanoseconds(duration.nanoseconds()));
}

bool Clock::wait_until_started(Context::SharedPtr context) {return wait_until_started(Duration::max(), context);}
bool Clock::wait_until_started(const Duration & timeout, Context::SharedPtr context, const Duration & wait_tick_ns)
{
  Clock steady(RCL_STEADY_TIME);
  Time begun = steady.now();
  while (!started()) {
    if (steady.now() - begun >= timeout || !steady.sleep_for(wait_tick_ns, context)) {
      return false;
    }
  }
  return true;
}
JumpHandler::SharedPtr Clock::create_jump_callback(
  JumpHandler::pre_callback_t pre, JumpHandler::post_callback_t post, const rcl_jump_threshold_t & threshold)
{
  auto made = std::make_shared<JumpHandler>(std::move(pre), std::move(post), threshold);
  if (handle().type != RCL_ROS_TIME || !node()) {
    return made;
  }
  std::weak_ptr<JumpHandler> weak = made;
  int64_t before = made->handle([weak](Unpacker &, Packer &) {
        auto me = weak.lock();
        if (me && me->pre_callback) {
          me->pre_callback();
        }
      });
  int64_t after = made->handle([weak](Unpacker & from, Packer &) {
        auto change = static_cast<rcl_clock_change_t>(from.i());
        auto me = weak.lock();
        if (me && me->post_callback) {
          me->post_callback({change, {from.i()}});
        }
      });
  Packer with = Packer{}.i(node()).i(threshold.on_clock_change).i(threshold.min_forward.nanoseconds);
  made->id = ask("jump_callback", with.i(threshold.min_backward.nanoseconds).i(before).i(after)).i();
  return made;
}

// -- loggers

namespace
{
/// The levels that let lines through, as the session told them. Only this program changes them.
struct Levels
{
  std::mutex lock;
  std::map<std::string, int> by_name;
};
Levels & levels()
{
  static Levels * known = new Levels;  // never destroyed: global nodes may still log
  return *known;
}
}  // namespace

static void forget_log_levels()
{
  std::lock_guard<std::mutex> hold(levels().lock);
  levels().by_name.clear();
}
bool log_enabled(const Logger & logger, int level)
{
  {
    std::lock_guard<std::mutex> hold(levels().lock);
    auto found = levels().by_name.find(logger.get_name());
    if (found != levels().by_name.end()) {
      return level >= found->second;
    }
  }
  int least = static_cast<int>(logger.get_effective_level());
  std::lock_guard<std::mutex> hold(levels().lock);
  levels().by_name[logger.get_name()] = least;
  return level >= least;
}
void Logger::set_level(Level level)
{
  const int severity = static_cast<int>(level);
  if (severity < 0 || severity > static_cast<int>(Level::Fatal) || severity % 10) {
    throw exceptions::RCLInvalidArgument("Invalid parameter: no level has the number " + std::to_string(severity));
  }
  ask("log_level", Packer{}.s(*name_).i(static_cast<int64_t>(level)));
  forget_log_levels();
}
Logger::Level Logger::get_effective_level() const
{
  return static_cast<Level>(ask("effective_level", Packer{}.s(*name_)).i());
}
void log(const Logger & logger, int level, const char * file, const char * function, int line, const char * format, ...)
{
  thread_local rcutils_log_location_t location;  // a handler may look at it later
  location = {function, file, static_cast<size_t>(line)};
  va_list args;
  va_start(args, format);
  rcutils_logging_get_output_handler()(&location, level, logger.get_name(), coursekit::system_now(), format, &args);
  va_end(args);
}
}  // namespace rclcpp

static std::atomic<rcutils_logging_output_handler_t> output_handler{rcutils_logging_console_output_handler};

rcutils_logging_output_handler_t rcutils_logging_get_output_handler() {return output_handler;}
void rcutils_logging_set_output_handler(rcutils_logging_output_handler_t handler) {output_handler = handler;}
void rcutils_logging_console_output_handler(
  const rcutils_log_location_t * location, int severity, const char * name, int64_t, const char * format, va_list * args)
{
  va_list first, again;  // the caller's own stay as they are: another handler may read them, too
  va_copy(first, *args);
  va_copy(again, *args);
  std::string text(static_cast<size_t>(std::max(vsnprintf(nullptr, 0, format, first), 0)) + 1, '\0');
  vsnprintf(&text[0], text.size(), format, again);
  va_end(again);
  va_end(first);
  text.pop_back();
  const rcutils_log_location_t place = location ? *location : rcutils_log_location_t{"", "", 0};
  coursekit::Packer line = coursekit::Packer{}.s(name ? name : "").i(severity).s(text);
  line.s(place.file_name).s(place.function_name).i(static_cast<int64_t>(place.line_number));
  try {
    coursekit::request("log", line);  // what is printed afterwards comes after it: a note would not be waited for
  } catch (const coursekit::Refused &) {  // a logger never fails
  }
}
