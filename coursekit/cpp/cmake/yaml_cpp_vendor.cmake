# yaml-cpp under the name of the package that brings it on a robot.
find_package(yaml-cpp REQUIRED)
target_link_libraries(yaml_cpp_vendor::yaml_cpp_vendor INTERFACE yaml-cpp)
