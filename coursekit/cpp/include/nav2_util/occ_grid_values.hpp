// What the numbers of an occupancy grid mean.
#pragma once
#include <cstdint>

namespace nav2_util
{
static constexpr int8_t OCC_GRID_UNKNOWN = -1;
static constexpr int8_t OCC_GRID_FREE = 0;
static constexpr int8_t OCC_GRID_OCCUPIED = 100;
}  // namespace nav2_util
