"""Chapter 1."""

WRONG = {
    "ch01.q1": [
        'rosout_type, rosout_publishers = "Log", 2',
        'rosout_type, rosout_publishers = "rcl_interfaces/msg/Log", 7',
        'rosout_type, rosout_publishers = "rcl_interfaces/msg/Log", "2"',
    ],
    "ch01.q2": [
        "moves = [(2.0, 0.0, 2.0), (2.0, 0.785, 0.5)]",
        "moves = [(0.0, 0.785, 1.0), (3.0, 0.0, 5.0)]",
        "moves = [(1.0, 2.0)]",
    ],
    "ch01.q3": [
        "commands = [\"ros2 service call /spawn turtlesim/srv/Spawn '{x: 2.5, y: 3.5, name: bob}'\"]",
        "commands = [\"service call /spawn turtlesim/srv/Spawn '{x: 2.5, y: 3.5, name: bob}'\"]",
        "commands = [\"service call /spawn turtlesim/srv/Spawn '{x: 2.5, y: 3.5}'\"]",
    ],
    "ch01.q4": [
        "dance = [(1.0, 2.0, 2.0)]",
        "dance = [(1.0 + step * 0.5, 2.0, 0.0) for step in range(10)]",
        "dance = [(1.0 + step * 0.5, 1.0, 3.0) for step in range(4)]",
    ],
}
