// Transforms of the last seconds, without waiting for them: a buffer of the session's, asked over the link.
#pragma once
#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <vector>

#include "coursekit/entity.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "geometry_msgs/msg/velocity_stamped.hpp"
#include "tf2/LinearMath/Vector3.h"
#include "tf2/buffer_core_interface.h"
#include "tf2/exceptions.h"
#include "tf2/time.h"
#include "tf2/transform_datatypes.h"

namespace tf2
{
using TransformableRequestHandle = uint64_t;
enum TransformableResult {TransformAvailable, TransformFailure};

class BufferCore : public coursekit::Entity, public BufferCoreInterface
{
public:
  explicit BufferCore(Duration cache_time = BUFFER_CORE_DEFAULT_CACHE_TIME);
  /// A buffer that the session has already, by its number.
  struct Shared {int64_t id;};
  explicit BufferCore(Shared buffer);
  virtual ~BufferCore() = default;

  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target, const std::string & source, const TimePoint & time) const override;
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target, const TimePoint & target_time, const std::string & source, const TimePoint & source_time,
    const std::string & fixed) const override;
  bool canTransform(
    const std::string & target, const std::string & source, const TimePoint & time,
    std::string * why_not = nullptr) const override;
  bool canTransform(
    const std::string & target, const TimePoint & target_time, const std::string & source, const TimePoint & source_time,
    const std::string & fixed, std::string * why_not = nullptr) const override;

  /// How fast a frame moves as seen from another, on average over an interval around a time.
  geometry_msgs::msg::VelocityStamped lookupVelocity(
    const std::string & tracking_frame, const std::string & observation_frame, const TimePoint & time,
    const Duration & averaging_interval) const;
  /// The same along the axes of a reference frame, for a point that moves with what is tracked.
  geometry_msgs::msg::VelocityStamped lookupVelocity(
    const std::string & tracking_frame, const std::string & observation_frame, const std::string & reference_frame,
    const Vector3 & reference_point, const std::string & reference_point_frame, const TimePoint & time,
    const Duration & averaging_interval) const;

  bool setTransform(const geometry_msgs::msg::TransformStamped & transform, const std::string & authority, bool is_static = false);
  void clear() override;
  std::string allFramesAsString() const;
  std::string allFramesAsYAML() const;
  std::string allFramesAsYAML(TimePoint) const {return allFramesAsYAML();}
  std::vector<std::string> getAllFrameNames() const override;
  bool _frameExists(const std::string & name) const;
  void _getFrameStrings(std::vector<std::string> & names) const;
  /// The tree as graphviz draws it.
  std::string _allFramesAsDot() const;
  std::string _allFramesAsDot(TimePoint now) const;
  /// The frame that one stands in; false where it stands in none.
  bool _getParent(const std::string & frame, TimePoint time, std::string & parent) const;
  /// The frames on the way from a source to a target.
  void _chainAsVector(
    const std::string & target, TimePoint target_time, const std::string & source, TimePoint source_time,
    const std::string & fixed, std::vector<std::string> & chain) const;
  using TransformableCallback = std::function<void (
        TransformableRequestHandle handle, const std::string & target, const std::string & source, TimePoint time,
        TransformableResult result)>;
  /// Call a function once, when a transform that this program sets makes another one known, or too old to come.
  /// 0 where it is known already; the greatest number where it is too old.
  TransformableRequestHandle addTransformableRequest(
    const TransformableCallback & callback, const std::string & target, const std::string & source, TimePoint time);
  void cancelTransformableRequest(TransformableRequestHandle handle);
  Duration getCacheLength() const {return cache_time_;}
  void setUsingDedicatedThread(bool uses) {dedicated_thread_ = uses;}
  bool isUsingDedicatedThread() const {return dedicated_thread_;}

protected:
  /// A buffer that answers `tf2_frames` for a node, by its number at the session; 0 for none.
  BufferCore(Duration cache_time, int64_t node);
  /// Called when this program has set a transform.
  virtual void transform_was_set() {}

private:
  struct TransformableRequest
  {
    TransformableRequestHandle handle;
    TransformableCallback callback;
    std::string target, source;
    TimePoint time;
  };
  /// Whether the buffer holds only newer transforms between two frames than it would need.
  bool is_too_old(const std::string & target, const std::string & source, const TimePoint & time) const;
  void answer_requests();

  std::mutex requests_lock_;
  std::list<TransformableRequest> requests_;
  TransformableRequestHandle last_request_ = 0;
  Duration cache_time_;
  bool dedicated_thread_ = false;
};
}  // namespace tf2
