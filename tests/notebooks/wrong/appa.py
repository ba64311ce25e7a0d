"""Appendix A."""

WRONG = {
    "appa.q1": [
        'command = "topic echo /turtle1/pose --once"',
        'command = "topic echo /turtle1/pose --field x"',
        'command = "topic echo /turtle1/pose --field y --once"',
        'command = "ros2 topic echo /turtle1/pose --field x --once"',
        'command = "topic ecco /turtle1/pose --field x --once"',
        'command = "topic echo \'/turtle1/pose --once"',
    ],
    "appa.q2": [
        "command = \"topic pub --once /turtle1/cmd_vel geometry_msgs/msg/Twist '{linear: {x: 1.5}, angular: {z: -0.75}}'\"",
        "command = \"topic pub /turtle1/cmd_vel geometry_msgs/msg/Twist '{linear: {x: 1.5}, angular: {z: -0.75}}'\"",
        "command = \"topic pub -r 4 /turtle1/cmd_vel geometry_msgs/msg/Twist '{linear: {x: 1.5}, angular: {z: 0.75}}'\"",
        "command = \"topic pub -r 4 /cmd_vel geometry_msgs/msg/Twist '{linear: {x: 1.5}, angular: {z: -0.75}}'\"",
    ],
    "appa.q3": [
        'commands = ["node list", "interface show turtlesim/srv/Spawn", "topic hz /turtle1/pose"]',
        'commands = ["node list -c", "service type /spawn", "topic hz /turtle1/pose"]',
        'commands = ["node list", "service type /spawn", "topic info /turtle1/pose"]',
        'commands = ["node list", "service type /spawn"]',
    ],
}
