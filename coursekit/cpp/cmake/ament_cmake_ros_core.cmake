# What later versions of ROS call it.
include("${COURSEKIT_CMAKE}/ament_cmake_ros.cmake")
