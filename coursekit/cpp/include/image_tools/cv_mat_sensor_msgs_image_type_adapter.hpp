// The name under which the demos of images have cv_bridge's container.
#pragma once
#include "cv_bridge/cv_mat_sensor_msgs_image_type_adapter.hpp"
#include "image_tools/visibility_control.h"

namespace image_tools
{
using cv_bridge::ROSCvMatContainer;
}  // namespace image_tools
