# Whoever finds this finds Eigen3 by ament's names too.
find_package(Eigen3 QUIET)
if(TARGET Eigen3::Eigen)
  set(Eigen3_TARGETS Eigen3::Eigen)
  get_target_property(Eigen3_INCLUDE_DIRS Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
endif()
