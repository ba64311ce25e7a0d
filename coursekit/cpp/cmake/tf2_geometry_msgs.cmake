# Humble's header is KDL's, and that brings Eigen to who asks for these messages only.
find_package(Eigen3 QUIET)
if(TARGET Eigen3::Eigen)
  target_link_libraries(tf2_geometry_msgs::tf2_geometry_msgs INTERFACE Eigen3::Eigen)
endif()
