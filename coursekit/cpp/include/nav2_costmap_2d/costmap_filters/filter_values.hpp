// What the filters of costmaps and their masks say in numbers.
#pragma once
#include <cstdint>

namespace nav2_costmap_2d
{
// Kinds of filters
static constexpr uint8_t KEEPOUT_FILTER = 0;
static constexpr uint8_t SPEED_FILTER_PERCENT = 1;
static constexpr uint8_t SPEED_FILTER_ABSOLUTE = 2;

// How a mask's values become the filter's, unless it is told otherwise: base + multiplier * value
static constexpr double BASE_DEFAULT = 0.0;
static constexpr double MULTIPLIER_DEFAULT = 1.0;

// Speeds
static constexpr int8_t SPEED_MASK_UNKNOWN = -1;
static constexpr int8_t SPEED_MASK_NO_LIMIT = 0;
static constexpr double NO_SPEED_LIMIT = 0.0;
}  // namespace nav2_costmap_2d
