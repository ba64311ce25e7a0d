// Programs are linked whole, so nothing needs to be exported; packages use these names in their own headers.
#pragma once
#define RCLCPP_PUBLIC
#define RCLCPP_LOCAL
#define RCLCPP_EXPORT
#define RCLCPP_IMPORT
#define RCLCPP_PUBLIC_TYPE
