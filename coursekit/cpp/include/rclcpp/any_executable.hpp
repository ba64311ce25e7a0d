// A callback that is ready, which an executor of one's own runs when it likes.
#pragma once
#include "coursekit/entity.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{
/// One that goes without being run gives its callback group free again.
struct AnyExecutable : coursekit::Entity
{
  RCLCPP_SMART_PTR_DEFINITIONS(AnyExecutable)
};
}  // namespace rclcpp
