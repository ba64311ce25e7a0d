#pragma once
#include "tf2_ros/buffer.h"

namespace tf2_ros
{
/// What upstream's buffer waits with; here it waits at the session.
class CreateTimerROS
{
public:
  template<class ... Interfaces>
  explicit CreateTimerROS(const Interfaces & ...) {}
};
}  // namespace tf2_ros
