"""C++ programs: rclcpp's API over a link to the session, and the headers of interfaces.

`include/` and `src/` are compiled into each program; `cmake/` replaces ament in a CMakeLists.txt; `nodes/compiled`
answers a program's requests. `packages/cmake_build` uses them for `colcon build`.
"""
