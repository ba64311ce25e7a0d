# tf2_eigen's header is Eigen's.
find_package(Eigen3 REQUIRED)
target_link_libraries(tf2_eigen::tf2_eigen INTERFACE Eigen3::Eigen)
