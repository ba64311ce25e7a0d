#pragma once
#include "rclcpp/memory_strategy.hpp"
