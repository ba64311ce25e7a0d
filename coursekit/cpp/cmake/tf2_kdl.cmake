# tf2_kdl's headers are KDL's.
find_package(orocos_kdl REQUIRED)
target_link_libraries(tf2_kdl::tf2_kdl INTERFACE orocos-kdl)
