# pcl_conversions' header is PCL's: the system's. Its compiled libraries speak the language of the system's compilers.
if(NOT CMAKE_CXX_COMPILER MATCHES "zig")
  find_package(PCL QUIET COMPONENTS common io)
endif()
if(NOT PCL_FOUND)
  message(FATAL_ERROR "PCL is not here: sudo apt install g++ libpcl-dev")
endif()
target_include_directories(pcl_conversions::pcl_conversions SYSTEM INTERFACE ${PCL_INCLUDE_DIRS})
target_link_libraries(pcl_conversions::pcl_conversions INTERFACE ${PCL_COMMON_LIBRARIES} ${PCL_IO_LIBRARIES})
