// A transform as a cache keeps it.
#pragma once
#include "tf2/LinearMath/Quaternion.h"
#include "tf2/LinearMath/Vector3.h"
#include "tf2/time.h"

namespace tf2
{
/// A frame by its number.
using CompactFrameID = uint32_t;

class TransformStorage
{
public:
  TransformStorage() = default;
  TransformStorage(
    const TimePoint & stamp, const Quaternion & rotation, const Vector3 & translation, CompactFrameID frame_id,
    CompactFrameID child_frame_id)
  : rotation_(rotation), translation_(translation), stamp_(stamp), frame_id_(frame_id), child_frame_id_(child_frame_id) {}
  bool operator==(const TransformStorage & other) const
  {
    return rotation_ == other.rotation_ && translation_ == other.translation_ && stamp_ == other.stamp_ &&
           frame_id_ == other.frame_id_ && child_frame_id_ == other.child_frame_id_;
  }
  bool operator!=(const TransformStorage & other) const {return !(*this == other);}

  Quaternion rotation_;
  Vector3 translation_;
  TimePoint stamp_;
  CompactFrameID frame_id_ = 0, child_frame_id_ = 0;
};
}  // namespace tf2
