// Quality of service: what a publisher offers and a subscription asks for.
#pragma once
#include <functional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "coursekit/frame.hpp"
#include "rcl/logging_rosout.h"
#include "rclcpp/duration.hpp"
#include "rmw/qos_string_conversions.h"
#include "rmw/types.h"

namespace rclcpp
{
enum class HistoryPolicy {SystemDefault, KeepLast, KeepAll, Unknown};
enum class ReliabilityPolicy {SystemDefault, Reliable, BestEffort, Unknown};
enum class DurabilityPolicy {SystemDefault, TransientLocal, Volatile, Unknown};
enum class LivelinessPolicy {SystemDefault = 0, Automatic = 1, ManualByTopic = 3, Unknown = 4};

std::string qos_policy_name_from_kind(rmw_qos_policy_kind_t policy_kind);

struct QoSInitialization
{
  rmw_qos_history_policy_t history_policy;
  size_t depth;
  QoSInitialization(rmw_qos_history_policy_t history, size_t depth_)
  : history_policy(history), depth(depth_) {}
  /// Anything but all messages is a number of the last ones.
  static QoSInitialization from_rmw(const rmw_qos_profile_t & profile)
  {
    if (profile.history == RMW_QOS_POLICY_HISTORY_KEEP_ALL) {
      return {RMW_QOS_POLICY_HISTORY_KEEP_ALL, 0};
    }
    return {RMW_QOS_POLICY_HISTORY_KEEP_LAST, profile.depth};
  }
};
struct KeepAll : QoSInitialization
{
  KeepAll()
  : QoSInitialization(RMW_QOS_POLICY_HISTORY_KEEP_ALL, 0) {}
};
struct KeepLast : QoSInitialization
{
  explicit KeepLast(size_t depth_)
  : QoSInitialization(RMW_QOS_POLICY_HISTORY_KEEP_LAST, depth_) {}
};

class QoS
{
public:
  explicit QoS(const QoSInitialization & history, const rmw_qos_profile_t & profile = rmw_qos_profile_default)
  : profile_(profile)
  {
    profile_.history = history.history_policy;
    profile_.depth = history.depth;
  }
  QoS(size_t depth)  // NOLINT: `create_publisher<T>(topic, 10)`
  : QoS(KeepLast(depth)) {}
  rmw_qos_profile_t & get_rmw_qos_profile() {return profile_;}
  const rmw_qos_profile_t & get_rmw_qos_profile() const {return profile_;}

  QoS & history(HistoryPolicy value) {return history(static_cast<rmw_qos_history_policy_t>(value));}
  QoS & history(rmw_qos_history_policy_t value) {profile_.history = value; return *this;}
  QoS & keep_last(size_t depth) {profile_.depth = depth; return history(RMW_QOS_POLICY_HISTORY_KEEP_LAST);}
  QoS & keep_all() {profile_.depth = 0; return history(RMW_QOS_POLICY_HISTORY_KEEP_ALL);}
  QoS & reliability(ReliabilityPolicy value) {return reliability(static_cast<rmw_qos_reliability_policy_t>(value));}
  QoS & reliability(rmw_qos_reliability_policy_t value) {profile_.reliability = value; return *this;}
  QoS & reliable() {return reliability(RMW_QOS_POLICY_RELIABILITY_RELIABLE);}
  QoS & best_effort() {return reliability(RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT);}
  QoS & durability(DurabilityPolicy value) {return durability(static_cast<rmw_qos_durability_policy_t>(value));}
  QoS & durability(rmw_qos_durability_policy_t value) {profile_.durability = value; return *this;}
  QoS & durability_volatile() {return durability(RMW_QOS_POLICY_DURABILITY_VOLATILE);}
  QoS & transient_local() {return durability(RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL);}
  QoS & deadline(const Duration & value) {return deadline(value.to_rmw_time());}
  QoS & deadline(rmw_time_t value) {profile_.deadline = value; return *this;}
  QoS & lifespan(const Duration & value) {return lifespan(value.to_rmw_time());}
  QoS & lifespan(rmw_time_t value) {profile_.lifespan = value; return *this;}
  QoS & liveliness(LivelinessPolicy value) {return liveliness(static_cast<rmw_qos_liveliness_policy_t>(value));}
  QoS & liveliness(rmw_qos_liveliness_policy_t value) {profile_.liveliness = value; return *this;}
  QoS & liveliness_lease_duration(const Duration & value) {return liveliness_lease_duration(value.to_rmw_time());}
  QoS & liveliness_lease_duration(rmw_time_t value) {profile_.liveliness_lease_duration = value; return *this;}
  QoS & avoid_ros_namespace_conventions(bool value)
  {
    profile_.avoid_ros_namespace_conventions = value;
    return *this;
  }

  HistoryPolicy history() const {return static_cast<HistoryPolicy>(profile_.history);}
  size_t depth() const {return profile_.depth;}
  ReliabilityPolicy reliability() const {return static_cast<ReliabilityPolicy>(profile_.reliability);}
  DurabilityPolicy durability() const {return static_cast<DurabilityPolicy>(profile_.durability);}
  LivelinessPolicy liveliness() const {return static_cast<LivelinessPolicy>(profile_.liveliness);}
  Duration deadline() const {return Duration::from_rmw_time(profile_.deadline);}
  Duration lifespan() const {return Duration::from_rmw_time(profile_.lifespan);}
  Duration liveliness_lease_duration() const {return Duration::from_rmw_time(profile_.liveliness_lease_duration);}
  bool avoid_ros_namespace_conventions() const {return profile_.avoid_ros_namespace_conventions;}

  void pack(coursekit::Packer & to) const
  {
    to.i(profile_.history).i(static_cast<int64_t>(profile_.depth)).i(profile_.reliability).i(profile_.durability);
    to.i(deadline().nanoseconds()).i(lifespan().nanoseconds()).i(profile_.liveliness);
    to.i(liveliness_lease_duration().nanoseconds());
  }
  static QoS unpack(coursekit::Unpacker & from)
  {
    auto history = static_cast<rmw_qos_history_policy_t>(from.i());
    QoS made(QoSInitialization(history, static_cast<size_t>(from.i())));
    made.reliability(static_cast<rmw_qos_reliability_policy_t>(from.i()));
    made.durability(static_cast<rmw_qos_durability_policy_t>(from.i()));
    made.deadline(Duration::from_nanoseconds(from.i()));
    made.lifespan(Duration::from_nanoseconds(from.i()));
    made.liveliness(static_cast<rmw_qos_liveliness_policy_t>(from.i()));
    return made.liveliness_lease_duration(Duration::from_nanoseconds(from.i()));
  }

private:
  rmw_qos_profile_t profile_;
};
inline bool operator==(const rmw_time_t & a, const rmw_time_t & b) {return a.sec == b.sec && a.nsec == b.nsec;}
inline bool operator==(const QoS & left, const QoS & right)
{
  auto & a = left.get_rmw_qos_profile();
  auto & b = right.get_rmw_qos_profile();
  return a.history == b.history && a.depth == b.depth && a.reliability == b.reliability &&
         a.durability == b.durability && a.deadline == b.deadline && a.lifespan == b.lifespan &&
         a.liveliness == b.liveliness && a.liveliness_lease_duration == b.liveliness_lease_duration &&
         a.avoid_ros_namespace_conventions == b.avoid_ros_namespace_conventions;
}
inline bool operator!=(const QoS & left, const QoS & right) {return !(left == right);}

#define COURSEKIT_QOS(Name, profile) \
  class Name : public QoS \
  { \
public: \
    explicit Name(const QoSInitialization & history = QoSInitialization::from_rmw(profile)) \
    : QoS(history, profile) {} \
  };
COURSEKIT_QOS(SensorDataQoS, rmw_qos_profile_sensor_data)
COURSEKIT_QOS(ParametersQoS, rmw_qos_profile_parameters)
COURSEKIT_QOS(ServicesQoS, rmw_qos_profile_services_default)
COURSEKIT_QOS(ParameterEventsQoS, rmw_qos_profile_parameter_events)
COURSEKIT_QOS(SystemDefaultsQoS, rmw_qos_profile_system_default)
class ClockQoS : public QoS
{
public:
  explicit ClockQoS(const QoSInitialization & history = KeepLast(1))
  : QoS(history) {best_effort();}
};
class RosoutQoS : public QoS
{
public:
  explicit RosoutQoS(const QoSInitialization & history = KeepLast(1000))
  : QoS(history)
  {
    transient_local();
    lifespan(Duration(10, 0));
  }
};

enum class QoSCompatibility {Ok, Warning, Error};
struct QoSCheckCompatibleResult
{
  QoSCompatibility compatibility;
  std::string reason;
};
/// Whether a publisher's messages would reach a subscription, and why not.
QoSCheckCompatibleResult qos_check_compatible(const QoS & publisher, const QoS & subscription);

enum class QosPolicyKind
{
  AvoidRosNamespaceConventions = RMW_QOS_POLICY_AVOID_ROS_NAMESPACE_CONVENTIONS,
  Deadline = RMW_QOS_POLICY_DEADLINE,
  Depth = RMW_QOS_POLICY_DEPTH,
  Durability = RMW_QOS_POLICY_DURABILITY,
  History = RMW_QOS_POLICY_HISTORY,
  Lifespan = RMW_QOS_POLICY_LIFESPAN,
  Liveliness = RMW_QOS_POLICY_LIVELINESS,
  LivelinessLeaseDuration = RMW_QOS_POLICY_LIVELINESS_LEASE_DURATION,
  Reliability = RMW_QOS_POLICY_RELIABILITY,
  Invalid = RMW_QOS_POLICY_INVALID,
};
/// A kind's word in names of parameters; throws std::invalid_argument for Invalid.
inline const char * qos_policy_kind_to_cstr(const QosPolicyKind & kind)
{
  const char * word = rmw_qos_policy_kind_to_str(static_cast<rmw_qos_policy_kind_t>(kind));
  if (!word) {
    throw std::invalid_argument("unknown QoS policy kind");
  }
  return word;
}
inline std::ostream & operator<<(std::ostream & out, const QosPolicyKind & kind) {return out << qos_policy_kind_to_cstr(kind);}
struct QosCallbackResult
{
  bool successful = true;
  std::string reason;
};
using QosCallback = std::function<QosCallbackResult (const QoS &)>;

/// Which policies may be set by parameters (`qos_overrides.TOPIC.publisher.depth`), and who judges the result.
class QosOverridingOptions
{
public:
  QosOverridingOptions() = default;
  QosOverridingOptions(
    std::initializer_list<QosPolicyKind> policies, QosCallback callback = nullptr, std::string id = "")
  : policies_(policies), callback_(std::move(callback)), id_(std::move(id)) {}
  static QosOverridingOptions with_default_policies(QosCallback callback = nullptr, std::string id = "")
  {
    return {{QosPolicyKind::History, QosPolicyKind::Depth, QosPolicyKind::Reliability}, std::move(callback), std::move(id)};
  }
  const std::string & get_id() const {return id_;}
  const std::vector<QosPolicyKind> & get_policy_kinds() const {return policies_;}
  const QosCallback & get_validation_callback() const {return callback_;}

private:
  std::vector<QosPolicyKind> policies_;
  QosCallback callback_;
  std::string id_;
};
}  // namespace rclcpp
