// The version of rclcpp whose names and behaviour these are: Humble's.
#pragma once
#define RCLCPP_VERSION_MAJOR (16)
#define RCLCPP_VERSION_MINOR (0)
#define RCLCPP_VERSION_PATCH (11)
#define RCLCPP_VERSION_STR "16.0.11"
#define RCLCPP_VERSION_GTE(major, minor, patch) \
  ((major < RCLCPP_VERSION_MAJOR) ? true : (major > RCLCPP_VERSION_MAJOR) ? false : \
  (minor < RCLCPP_VERSION_MINOR) ? true : (minor > RCLCPP_VERSION_MINOR) ? false : (patch <= RCLCPP_VERSION_PATCH))
