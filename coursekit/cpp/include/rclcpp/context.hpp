// What init() starts and shutdown() ends: the default context, and others that a program makes itself.
#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <typeindex>
#include <unordered_map>
#include <vector>

#include "rcl/init_options.h"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/macros.hpp"
#include "rcutils/allocator.h"

namespace rclcpp
{
class ContextAlreadyInitialized : public std::runtime_error
{
public:
  ContextAlreadyInitialized()
  : std::runtime_error("context is already initialized") {}
};

class InitOptions
{
public:
  InitOptions() = default;
  explicit InitOptions(const rcl_allocator_t &) {}
  bool shutdown_on_signal = true;
  InitOptions & auto_initialize_logging(bool initialize)
  {
    auto_initialize_logging_ = initialize;
    return *this;
  }
  bool auto_initialize_logging() const {return auto_initialize_logging_;}
  void set_domain_id(size_t id) {domain_id_ = static_cast<int64_t>(id);}
  /// The domain that was set; RCL_DEFAULT_DOMAIN_ID where none was.
  size_t get_domain_id() const {return domain_id_ < 0 ? RCL_DEFAULT_DOMAIN_ID : static_cast<size_t>(domain_id_);}
  void use_default_domain_id() {domain_id_ = -1;}
  const rcl_init_options_t * get_rcl_init_options() const
  {
    rcl_.impl = this;
    return &rcl_;
  }

private:
  int64_t domain_id_ = -1;
  bool auto_initialize_logging_ = true;
  mutable rcl_init_options_t rcl_{nullptr};
  friend class Context;
};

struct ShutdownCallbackHandle {int64_t number = 0;};
using OnShutdownCallbackHandle = ShutdownCallbackHandle;
using PreShutdownCallbackHandle = ShutdownCallbackHandle;

class Context : public std::enable_shared_from_this<Context>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Context)
  Context();
  virtual ~Context() = default;
  using OnShutdownCallback = std::function<void ()>;

  virtual void init(int argc, char const * const * argv, const InitOptions & options = InitOptions());
  bool is_valid() const;
  virtual bool shutdown(const std::string & reason);
  std::string shutdown_reason() const {return reason_;}
  const InitOptions & get_init_options() const {return options_;}
  virtual OnShutdownCallback on_shutdown(OnShutdownCallback callback);
  virtual OnShutdownCallbackHandle add_on_shutdown_callback(OnShutdownCallback callback);
  virtual bool remove_on_shutdown_callback(const OnShutdownCallbackHandle & handle);
  virtual PreShutdownCallbackHandle add_pre_shutdown_callback(OnShutdownCallback callback);
  virtual bool remove_pre_shutdown_callback(const PreShutdownCallbackHandle & handle);
  std::vector<OnShutdownCallback> get_on_shutdown_callbacks() const {return callbacks_in(after_);}
  std::vector<OnShutdownCallback> get_pre_shutdown_callbacks() const {return callbacks_in(before_);}
  /// The ROS domain that it is in; throws RCLError where it has not been initialized.
  size_t get_domain_id() const;
  bool sleep_for(const std::chrono::nanoseconds & duration);
  /// What belongs to this context: one of each type, made of the arguments when it is asked for first.
  template<class SubContext, class ... Args>
  std::shared_ptr<SubContext> get_sub_context(Args && ... args)
  {
    std::lock_guard<std::recursive_mutex> hold(sub_lock_);
    std::shared_ptr<void> & kept = sub_contexts_[typeid(SubContext)];
    if (!kept) {
      kept = std::make_shared<SubContext>(std::forward<Args>(args)...);
    }
    return std::static_pointer_cast<SubContext>(kept);
  }
  /// The session's number of it; 0 for the default one.
  int64_t number() const {return number_;}

protected:
  explicit Context(int64_t number)
  : number_(number) {}

private:
  using Callbacks = std::vector<std::pair<int64_t, OnShutdownCallback>>;
  void call(const Callbacks & callbacks);
  bool remove(Callbacks & callbacks, const ShutdownCallbackHandle & handle);
  std::vector<OnShutdownCallback> callbacks_in(const Callbacks & callbacks) const;
  const int64_t number_;
  bool valid_ = false;
  std::string reason_;
  InitOptions options_;
  mutable std::mutex lock_;
  int64_t next_ = 1;
  Callbacks before_, after_;
  std::recursive_mutex sub_lock_;
  std::unordered_map<std::type_index, std::shared_ptr<void>> sub_contexts_;
};

namespace contexts
{
class DefaultContext;
/// The one that init() starts.
std::shared_ptr<DefaultContext> get_global_default_context();
/// Of its kind a program may make others, which have nothing in common with that one.
class DefaultContext : public Context
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(DefaultContext)
  DefaultContext() = default;

private:
  friend SharedPtr get_global_default_context();
  explicit DefaultContext(int64_t number)
  : Context(number) {}
};
}  // namespace contexts
}  // namespace rclcpp
