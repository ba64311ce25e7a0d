# ament_cmake_ros: libraries are shared unless their package says otherwise.
option(BUILD_SHARED_LIBS "Create shared libraries by default" ON)
include("${COURSEKIT_CMAKE}/ament_cmake.cmake")
if(NOT TARGET ament_cmake_ros_core::ament_ros_defaults)
  _add_library(ament_cmake_ros_core::ament_ros_defaults INTERFACE IMPORTED GLOBAL)
endif()
