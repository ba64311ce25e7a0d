"""C++ programs: rclcpp's names over a link to the session, and the headers of interfaces.

`include/` and `src/` are compiled into each program; `cmake/` takes ament's place in a CMakeLists.txt; `nodes/compiled`
answers what a program asks. `packages/cmake_build` uses them for `colcon build`.
"""
