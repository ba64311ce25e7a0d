// Every name here is visible.
#pragma once
#define RCLCPP_LIFECYCLE_PUBLIC
#define RCLCPP_LIFECYCLE_LOCAL
#define RCLCPP_LIFECYCLE_PUBLIC_TYPE
