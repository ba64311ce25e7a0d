"""C++ programs: rclcpp's names over a link to the session, and the headers of interfaces.

`include/` and `src/` are compiled into each program; `nodes/compiled` answers what the program asks. `colcon build` does not
use them yet: it still names the C++ that it skips.
"""
