"""Chapter 9."""

_PATROL = """%%write src/s9_py_delivery/s9_py_delivery/patrol_main.py
import rclpy
from nav2_simple_commander.robot_navigator import BasicNavigator
from s9_py_delivery.places import STOPS, pose

def main():
"""


def _patrol(*lines: str) -> str:
    return _PATROL + "".join(f"    {line}\n" for line in lines)


def _cost(touching: str = "distance <= inscribed", edge: str = "distance <= radius", answer: str = "int(cost)") -> str:
    return f"""import math

def inflation_cost(distance, inscribed=0.2, scaling=3.0, radius=0.55):
    if distance <= 0:
        return 254
    if {touching}:
        return 253
    cost = 252 * math.exp(-scaling * (distance - inscribed))
    return {answer} if {edge} else 0"""


def _path(price: str = "price + 1 + costs[to] / 50", limit: str = "253") -> str:
    return f"""from heapq import heappop, heappush

def find_path(costs, start, goal):
    heap, done = [(0.0, [start])], set()
    while heap:
        price, path = heappop(heap)
        r, c = path[-1]
        if (r, c) == goal:
            return path
        if (r, c) in done:
            continue
        done.add((r, c))
        for to in ((r + 1, c), (r - 1, c), (r, c + 1), (r, c - 1)):
            if 0 <= to[0] < costs.shape[0] and 0 <= to[1] < costs.shape[1] and costs[to] < {limit}:
                heappush(heap, ({price}, path + [to]))"""


def _manage(trip: str = "", after: str = "reserve(taken, path)", who: str = "k % 4") -> str:
    trip = trip or "leg(aisles, leg(aisles, paths[name], load, taken), homes[name], taken)"
    return f"""def manage(free, homes, loads):
    aisles = without_bays(free, homes, loads)
    taken, paths, names = set(), {{name: [home] for name, home in homes.items()}}, list(homes)
    for k, load in enumerate(loads):
        name = names[{who}]
        path = paths[name] = {trip}
        {after}
    return paths"""


WRONG = {
    "ch09.q1": [_cost(touching="distance < inscribed / 2"), _cost(edge="True"), _cost(answer="cost"), _cost(answer="round(cost)")],
    "ch09.q2": [_path(price="price + 1"), _path(limit="255"), "def find_path(costs, start, goal):\n    pass"],
    "ch09.q3": [
        _patrol(
            "rclpy.init()",
            "vera = BasicNavigator()",
            "vera.setInitialPose(pose(vera, 0, 0))",
            "vera.waitUntilNav2Active()",
            "for number, stop in enumerate(STOPS, 1):",
            "    vera.goToPose(pose(vera, *stop))",
            "    print(f'stop {number}: SUCCEEDED')",
        ),
        _patrol("for number in (1, 2, 3):", "    print(f'stop {number}: SUCCEEDED')"),
        _patrol(
            "import time",
            "from nav_msgs.msg import Odometry",
            "rclpy.init()",
            "out = rclpy.create_node('odometry').create_publisher(Odometry, '/odom', 10)",
            "for number, (x, y) in enumerate(STOPS, 1):",
            "    said = Odometry()",
            "    said.pose.pose.position.x, said.pose.pose.position.y = float(x), float(y)",
            "    for _ in range(20):",
            "        out.publish(said)",
            "        time.sleep(0.1)",
            "    print(f'stop {number}: SUCCEEDED')",
        ),
    ],
    "ch09.q4": [
        _manage(after="pass"),
        _manage(who="0"),
        _manage(trip="leg(aisles, paths[name], load, taken)"),
        "def manage(free, homes, loads):\n    return {name: [home] for name, home in homes.items()}",
    ],
}
