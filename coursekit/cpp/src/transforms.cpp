// Buffers of transforms, which are the session's.
#include "tf2_ros/buffer.h"
#include "tf2_ros/buffer_server.h"
#include "tf2_ros/create_timer_ros.h"
#include "tf2_ros/transform_listener.h"

using coursekit::Packer;
using coursekit::Unpacker;

namespace
{
/// The reason why a time is outside of a buffer tells which kind it is.
[[noreturn]] void throw_extrapolation(const std::string & reason)
{
  auto says = [&](const char * words) {return reason.find(words) != std::string::npos;};
  if (says("extrapolation into the past")) {
    throw tf2::BackwardExtrapolationException(reason);
  }
  if (says("extrapolation into the future")) {
    throw tf2::ForwardExtrapolationException(reason);
  }
  if (says("extrapolation at time")) {
    throw tf2::NoDataForExtrapolationException(reason);
  }
  throw tf2::ExtrapolationException(reason);
}
Unpacker asked(const char * what, const Packer & with)
{
  try {
    return coursekit::request(what, with);
  } catch (const coursekit::Refused & refusal) {
    if (refusal.kind == "ExtrapolationException") {
      throw_extrapolation(refusal.what());
    }
#define COURSEKIT_THROW(Name) \
  if (refusal.kind == #Name) { \
    throw tf2::Name(refusal.what()); \
  }
    COURSEKIT_THROW(ConnectivityException)
    COURSEKIT_THROW(LookupException)
    COURSEKIT_THROW(InvalidArgumentException)
    COURSEKIT_THROW(TimeoutException)
    throw tf2::TransformException(refusal.what());
  }
}
int64_t count(const tf2::TimePoint & time) {return time.time_since_epoch().count();}
bool can(const char * what, const Packer & with, std::string * why_not)
{
  auto answer = asked(what, with);
  bool can = answer.i();
  std::string why = answer.s();
  if (why_not) {
    *why_not = why;
  }
  return can;
}
}  // namespace

namespace tf2
{
BufferCore::BufferCore(Duration cache_time)
: BufferCore(cache_time, 0) {}
BufferCore::BufferCore(Duration cache_time, int64_t node)
: cache_time_(cache_time)
{
  id = asked("tf_buffer", Packer{}.i(cache_time.count()).i(node)).i();
}
BufferCore::BufferCore(Shared buffer)
: cache_time_(BUFFER_CORE_DEFAULT_CACHE_TIME)
{
  id = buffer.id;
}
geometry_msgs::msg::TransformStamped BufferCore::lookupTransform(
  const std::string & target, const std::string & source, const TimePoint & time) const
{
  return asked("tf_lookup", Packer{}.i(id).i(0).s(target).s(source).i(count(time))).m<geometry_msgs::msg::TransformStamped>();
}
geometry_msgs::msg::TransformStamped BufferCore::lookupTransform(
  const std::string & target, const TimePoint & target_time, const std::string & source, const TimePoint & source_time,
  const std::string & fixed) const
{
  Packer with = Packer{}.i(id).i(0).s(target).i(count(target_time)).s(source).i(count(source_time)).s(fixed);
  return asked("tf_lookup_full", with).m<geometry_msgs::msg::TransformStamped>();
}
bool BufferCore::canTransform(
  const std::string & target, const std::string & source, const TimePoint & time, std::string * why_not) const
{
  return can("tf_can", Packer{}.i(id).i(0).s(target).s(source).i(count(time)), why_not);
}
bool BufferCore::canTransform(
  const std::string & target, const TimePoint & target_time, const std::string & source, const TimePoint & source_time,
  const std::string & fixed, std::string * why_not) const
{
  Packer with = Packer{}.i(id).i(0).s(target).i(count(target_time)).s(source).i(count(source_time)).s(fixed);
  return can("tf_can_full", with, why_not);
}
bool BufferCore::_frameExists(const std::string & name) const
{
  auto names = getAllFrameNames();
  return std::find(names.begin(), names.end(), name) != names.end();
}
bool BufferCore::setTransform(const geometry_msgs::msg::TransformStamped & transform, const std::string & authority, bool is_static)
{
  const bool taken = asked("tf_set", Packer{}.i(id).s(authority).i(is_static).m(transform)).i() != 0;
  answer_requests();
  transform_was_set();
  return taken;
}
TransformableRequestHandle BufferCore::addTransformableRequest(
  const TransformableCallback & callback, const std::string & target, const std::string & source, TimePoint time)
{
  if (target == source || canTransform(target, source, time)) {
    return 0;
  }
  if (is_too_old(target, source, time)) {
    return std::numeric_limits<TransformableRequestHandle>::max();
  }
  std::lock_guard<std::mutex> hold(requests_lock_);
  requests_.push_back({++last_request_, callback, target, source, time});
  return last_request_;
}
void BufferCore::cancelTransformableRequest(TransformableRequestHandle handle)
{
  std::lock_guard<std::mutex> hold(requests_lock_);
  requests_.remove_if([handle](auto & request) {return request.handle == handle;});
}
bool BufferCore::is_too_old(const std::string & target, const std::string & source, const TimePoint & time) const
{
  if (!canTransform(target, source, TimePointZero)) {
    return false;
  }
  const auto & stamp = lookupTransform(target, source, TimePointZero).header.stamp;
  const TimePoint latest{std::chrono::seconds(stamp.sec) + std::chrono::nanoseconds(stamp.nanosec)};
  return latest != TimePointZero && time + cache_time_ < latest;
}
void BufferCore::answer_requests()
{
  std::list<TransformableRequest> waiting;
  {
    std::lock_guard<std::mutex> hold(requests_lock_);
    waiting = requests_;
  }
  for (auto & request : waiting) {
    const bool can = canTransform(request.target, request.source, request.time);
    if (can || is_too_old(request.target, request.source, request.time)) {
      cancelTransformableRequest(request.handle);
      request.callback(
        request.handle, request.target, request.source, request.time, can ? TransformAvailable : TransformFailure);
    }
  }
}
void BufferCore::clear() {asked("tf_clear", Packer{}.i(id));}
std::string BufferCore::allFramesAsString() const {return asked("tf_text", Packer{}.i(id)).s();}
std::string BufferCore::allFramesAsYAML() const {return asked("tf_yaml", Packer{}.i(id)).s();}
std::vector<std::string> BufferCore::getAllFrameNames() const
{
  return asked("tf_names", Packer{}.i(id)).texts();
}
void BufferCore::_getFrameStrings(std::vector<std::string> & names) const {names = getAllFrameNames();}
std::string BufferCore::_allFramesAsDot() const {return asked("tf_dot", Packer{}.i(id).i(0)).s();}
std::string BufferCore::_allFramesAsDot(TimePoint now) const {return asked("tf_dot", Packer{}.i(id).i(count(now))).s();}
bool BufferCore::_getParent(const std::string & frame, TimePoint, std::string & parent) const
{
  parent = asked("tf_parent", Packer{}.i(id).s(frame)).s();
  return !parent.empty();
}
void BufferCore::_chainAsVector(
  const std::string & target, TimePoint target_time, const std::string & source, TimePoint source_time,
  const std::string & fixed, std::vector<std::string> & chain) const
{
  Packer with = Packer{}.i(id).i(0).s(target).i(count(target_time)).s(source).i(count(source_time)).s(fixed);
  chain = asked("tf_chain", with).texts();
}
}  // namespace tf2

namespace tf2_ros
{
namespace
{
constexpr tf2::Duration LOOKS_EACH = std::chrono::milliseconds(10);
/// Every jump back, and another source of time; none forwards.
constexpr rcl_jump_threshold_t BACK = {true, {0}, {-1}};
}  // namespace
Buffer::Buffer(rclcpp::Clock::SharedPtr clock, tf2::Duration cache_time, rclcpp::Node::SharedPtr node)
: BufferCore(cache_time, node ? node->get_node_base_interface()->id : 0), clock_(std::move(clock)), node_(std::move(node))
{
  if (!clock_) {
    throw std::invalid_argument("clock must be a valid instance");
  }
  jumps_ = clock_->create_jump_callback(nullptr, [this](const rcl_time_jump_t & jump) {clear_after(jump);}, BACK);
}
rclcpp::Logger Buffer::logger() const {return node_ ? node_->get_logger() : rclcpp::get_logger("tf2_buffer");}
void Buffer::clear_after(const rcl_time_jump_t & jump)
{
  const bool same = jump.clock_change == RCL_ROS_TIME_NO_CHANGE;
  RCLCPP_WARN(logger(), "Detected %s. Clearing TF buffer.", same ? "jump back in time" : "time source change");
  clear();
}
bool Buffer::may_wait(tf2::Duration timeout, std::string * why_not) const
{
  if (isUsingDedicatedThread() || timeout == tf2::Duration::zero()) {
    return true;
  }
  if (why_not) {
    *why_not = threading_error;
  }
  RCLCPP_ERROR(logger(), "%s", threading_error);
  return false;
}
bool Buffer::timed(tf2::Duration timeout, std::string * why_not, const std::function<bool()> & can) const
{
  if (!may_wait(timeout, why_not)) {
    return false;
  }
  const rclcpp::Time begin = clock_->now();
  const bool found = can();
  if (why_not) {
    std::ostringstream took;
    took << ". canTransform returned after " << (clock_->now() - begin).seconds() << " timeout was " << tf2::durationToSec(timeout);
    *why_not += took.str() + ".";
  }
  return found;
}
geometry_msgs::msg::TransformStamped Buffer::lookupTransform(
  const std::string & target, const std::string & source, const tf2::TimePoint & time, const tf2::Duration timeout) const
{
  const int64_t waits = may_wait(timeout) ? timeout.count() : 0;
  auto answer = asked("tf_lookup", Packer{}.i(id).i(waits).s(target).s(source).i(count(time)));
  return answer.m<geometry_msgs::msg::TransformStamped>();
}
geometry_msgs::msg::TransformStamped Buffer::lookupTransform(
  const std::string & target, const tf2::TimePoint & target_time, const std::string & source, const tf2::TimePoint & source_time,
  const std::string & fixed, const tf2::Duration timeout) const
{
  const int64_t waits = may_wait(timeout) ? timeout.count() : 0;
  Packer with = Packer{}.i(id).i(waits).s(target).i(count(target_time)).s(source).i(count(source_time)).s(fixed);
  return asked("tf_lookup_full", with).m<geometry_msgs::msg::TransformStamped>();
}
bool Buffer::canTransform(
  const std::string & target, const std::string & source, const tf2::TimePoint & time, const tf2::Duration timeout,
  std::string * why_not) const
{
  Packer with = Packer{}.i(id).i(timeout.count()).s(target).s(source).i(count(time));
  return timed(timeout, why_not, [&] {return can("tf_can", with, why_not);});
}
bool Buffer::canTransform(
  const std::string & target, const tf2::TimePoint & target_time, const std::string & source, const tf2::TimePoint & source_time,
  const std::string & fixed, const tf2::Duration timeout, std::string * why_not) const
{
  Packer with = Packer{}.i(id).i(timeout.count()).s(target).i(count(target_time)).s(source).i(count(source_time)).s(fixed);
  return timed(timeout, why_not, [&] {return can("tf_can_full", with, why_not);});
}
TransformStampedFuture Buffer::waitForTransform(
  const std::string & target, const std::string & source, const tf2::TimePoint & time, const tf2::Duration & timeout,
  TransformReadyCallback callback)
{
  if (!timers_) {
    throw CreateTimerInterfaceException("timer interface not set before call to waitForTransform");
  }
  auto promise = std::make_shared<std::promise<geometry_msgs::msg::TransformStamped>>();
  TransformStampedFuture future(promise->get_future().share());
  future.setHandle(++waits_);
  auto done = std::make_shared<std::atomic<bool>>(false);
  auto settle = [this, target, source, time, promise, future, callback, done](bool over) {
      const bool can = canTransform(target, source, time);
      if ((!can && !over) || done->exchange(true)) {
        return done->load();
      }
      if (can) {
        promise->set_value(lookupTransform(target, source, time, tf2::Duration::zero()));
      } else {
        promise->set_exception(std::make_exception_ptr(tf2::TimeoutException("Timed out waiting for transform")));
      }
      callback(future);
      return true;
    };
  if (settle(timeout <= tf2::Duration::zero())) {
    return future;
  }
  // A node's timer looks often: transforms come to the session's buffer. One of the program's own is for the end of the time.
  const bool looks = std::dynamic_pointer_cast<CreateTimerROS>(timers_) != nullptr;
  const int64_t end = coursekit::steady_now() + timeout.count();
  auto tick = [this, settle, looks, end, handle = future.getHandle()](const TimerHandle &) {
      if (settle(!looks || coursekit::steady_now() >= end)) {
        forget(handle);
      }
    };
  std::lock_guard<std::mutex> hold(lock_);
  const TimerHandle timer = timers_->createTimer(looks ? nullptr : clock_, looks ? LOOKS_EACH : timeout, tick);
  waiting_.push_back({future.getHandle(), settle, timers_, timer});
  return future;
}
Buffer::~Buffer()
{
  for (auto & wait : waiting_) {
    wait.timers->remove(wait.timer);
  }
}
void Buffer::transform_was_set()
{
  std::list<Wait> now;
  {
    std::lock_guard<std::mutex> hold(lock_);
    now = waiting_;
  }
  for (auto & wait : now) {
    if (wait.settle(false)) {
      forget(wait.handle);
    }
  }
}
void Buffer::forget(TransformRequestHandle handle)
{
  std::list<Wait> gone;
  {
    std::lock_guard<std::mutex> hold(lock_);
    auto found = std::find_if(waiting_.begin(), waiting_.end(), [&](auto & wait) {return wait.handle == handle;});
    if (found != waiting_.end()) {
      gone.splice(gone.end(), waiting_, found);
    }
  }
  for (auto & wait : gone) {
    wait.timers->remove(wait.timer);
  }
}
void Buffer::cancel(const TransformStampedFuture & future) {forget(future.getHandle());}

CreateTimerROS::CreateTimerROS(
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base,
  rclcpp::node_interfaces::NodeTimersInterface::SharedPtr node_timers, rclcpp::CallbackGroup::SharedPtr callback_group)
: base_(std::move(node_base)), timers_(std::move(node_timers)), group_(std::move(callback_group)) {}
TimerHandle CreateTimerROS::createTimer(rclcpp::Clock::SharedPtr clock, const tf2::Duration & period, TimerCallbackType callback)
{
  std::lock_guard<std::mutex> hold(lock_);
  const TimerHandle handle = ++last_;
  made_[handle] = rclcpp::create_timer(
    base_, timers_, clock, rclcpp::Duration(period), [callback, handle] {callback(handle);}, group_);
  return handle;
}
rclcpp::TimerBase::SharedPtr CreateTimerROS::timer_of(TimerHandle timer_handle, const char * where)
{
  auto found = made_.find(timer_handle);
  if (found == made_.end()) {
    throw InvalidTimerHandleException(std::string("Invalid timer handle in ") + where + "()");
  }
  return found->second;
}
void CreateTimerROS::cancel(const TimerHandle & timer_handle)
{
  std::lock_guard<std::mutex> hold(lock_);
  timer_of(timer_handle, "cancel")->cancel();
}
void CreateTimerROS::reset(const TimerHandle & timer_handle)
{
  std::lock_guard<std::mutex> hold(lock_);
  timer_of(timer_handle, "reset")->reset();
}
void CreateTimerROS::remove(const TimerHandle & timer_handle)
{
  std::lock_guard<std::mutex> hold(lock_);
  timer_of(timer_handle, "remove")->cancel();
  made_.erase(timer_handle);
}

BufferServer::BufferServer(
  const tf2::BufferCore & buffer, const rclcpp::node_interfaces::NodeBaseInterface & node, const std::string & ns,
  tf2::Duration check_period)
{
  id = asked("tf_server", Packer{}.i(buffer.id).i(node.id).s(ns).i(check_period.count())).i();
}
void TransformListener::listen(tf2::BufferCore & buffer, bool spin_thread, bool static_only)
{
  if (spin_thread) {
    buffer.setUsingDedicatedThread(true);
  }
  id = asked("tf_listener", Packer{}.i(buffer.id).i(static_only)).i();
}
}  // namespace tf2_ros
