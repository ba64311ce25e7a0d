# kdl_parser's headers are KDL's.
find_package(orocos_kdl REQUIRED)
target_link_libraries(kdl_parser::kdl_parser INTERFACE orocos-kdl)
