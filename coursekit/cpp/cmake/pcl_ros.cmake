# pcl_ros' header stands on pcl_conversions'.
find_package(pcl_conversions REQUIRED)
target_link_libraries(pcl_ros::pcl_ros INTERFACE pcl_conversions::pcl_conversions)
