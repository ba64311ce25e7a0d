#pragma once
#include "rclcpp_components/node_factory.hpp"
