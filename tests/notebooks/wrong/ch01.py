"""Chapter 1."""



def _stage(pen: str) -> str:
    spawn = "service call /spawn turtlesim/srv/Spawn '{x: 2.5, y: 3.5, name: bob}'"
    return f'''commands = ["{spawn}", """service call /turtle1/set_pen turtlesim/srv/SetPen "{pen}" """]'''


WRONG = {
    "ch01.q1": [
        'rosout_type, rosout_publishers = "Log", 2',
        'rosout_type, rosout_publishers = "rcl_interfaces/msg/Log", 7',
        'rosout_type, rosout_publishers = "rcl_interfaces/msg/Log", "2"',
        'rosout_type, rosout_publishers = "rcl_interfaces/msg/Log", 1',
        'rosout_type, rosout_publishers = "rcl_interfaces/msg/Log", True',
    ],
    "ch01.q2": [
        "moves = [(2.0, 0.0, 2.0), (2.0, 0.785, 0.5)]",
        "moves = [(0.0, 0.785, 1.0), (3.0, 0.0, 5.0)]",
        "moves = [(1.0, 2.0)]",
        "moves = [(0.0, 45.0, 1.0), (1.5, 0.0, 3.8)]",
        "moves = [(0.0, 0.785, 1.0), (1.5, float('nan'), 3.8)]",
    ],
    "ch01.q3": [
        "commands = [\"ros2 service call /spawn turtlesim/srv/Spawn '{x: 2.5, y: 3.5, name: bob}'\"]",
        "commands = [\"service call /spawn turtlesim/srv/Spawn '{x: 2.5, y: 3.5, name: bob}'\"]",
        "commands = [\"service call /spawn turtlesim/srv/Spawn '{x: 2.5, y: 3.5}'\"]",
        _stage("{r: 255, g: 0, b: 0, width: 1}"),
        _stage("{r: 255, g: 0, b: 0, width: 9}"),
        _stage("{r: 255, g: 0, b: 0, width: 5, 'off': 1}"),
        _stage("{r: 255, g: 0, b: 0, width: 5, off: 0}"),
    ],
    "ch01.q4": [
        "dance = [(1.0 + step * 0.5, float('nan'), float('nan')) for step in range(10)]",
        "dance = [(1.0, 0.0, 90.0)]",
        "dance = [(1.0, 2.0, 2.0)]",
        "dance = [(1.0 + step * 0.5, 2.0, 0.0) for step in range(10)]",
        "dance = [(1.0 + step * 0.5, 1.0, 3.0) for step in range(4)]",
    ],
}
RIGHT = {"ch01.q3": [_stage("{r: 255, g: 0, b: 0, width: 5, 'off': 0}")]}
