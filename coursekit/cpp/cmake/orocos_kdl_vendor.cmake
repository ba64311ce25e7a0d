# orocos_kdl_vendor's headers are KDL's.
find_package(orocos_kdl REQUIRED)
target_link_libraries(orocos_kdl_vendor::orocos_kdl_vendor INTERFACE orocos-kdl)
