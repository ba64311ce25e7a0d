"""`make bench`: the table of DESIGN's numbers that can be measured here."""

import json
import os
import subprocess
import sys
from pathlib import Path

from tests.conformance.loopback import alone
from tests.slam.data import MISSING, folder

HERE = Path(__file__).parent
PEER = HERE.parents[1] / ".venv-ros" / "bin" / "python"


def measure(python: str | Path, script: str, *args: str) -> str:
    """The output of a script, run from a folder where nothing of ours is found by accident."""
    env = {key: value for key, value in os.environ.items() if not key.startswith(("PYTHON", "COURSEKIT"))}
    env["COURSEKIT_ALONE"] = "1"  # a session that happens to run shall not be measured
    done = subprocess.run(
        [str(python), str(HERE / script), *args], env=env, cwd="/", capture_output=True, encoding="utf-8", check=True
    )
    return done.stdout.strip().splitlines()[-1]


def row(what: str, ours: float, peer: float | None, goal: str, unit: str = "µs") -> None:
    """Print a line of the table."""
    theirs = "not installed" if peer is None else f"{peer:.1f} {unit}"
    ratio = "" if peer is None else f"{peer / ours:.0f} ×"
    print(f"| {what} | {ours:.1f} {unit} | {theirs} | {ratio} | {goal} |")


def link_poses() -> None:
    """Print the table of forward kinematics."""
    print("\n| all link poses of a 16-link robot | coursekit | as 4×4 | yourdfpy | pinocchio, 4×4 | goal |")
    print("|---|---|---|---|---|---|")
    for name, times in json.loads(measure(sys.executable, "link_poses.py")).items():
        cells = [f"{time:.1f} µs" if time is not None else "not installed" for time in times.values()]
        print(f"| {name} axes | {' | '.join(cells)} | ≤ 20 µs |")


def transforms() -> None:
    """Print the table of lookups."""
    print("\n| lookup_transform, every edge moves | coursekit | C++ tf2 (Python binding) | goal |")
    print("|---|---|---|---|")
    words = {"latest": "newest, after new data", "again": "the same once more"}
    words |= {"between": "interpolated", "once": "interpolated, elsewhere each time"}
    for depth, times in json.loads(measure(sys.executable, "transforms.py")).items():
        for kind, ours in times["ours"].items():
            theirs = "not installed" if times["peer"] is None else f"{times['peer'][kind]:.1f} µs"
            goal = {"5": "≤ 8 µs", "15": "≤ 15 µs"}[depth]
            print(f"| depth {depth}, {words[kind]} | {ours:.1f} µs | {theirs} | {goal} |")


def lidar() -> None:
    """Print the table of scans."""
    print("\n| scan of 360 beams | coursekit | pymunk, ray by ray | ratio | goal |\n|---|---|---|---|---|")
    for edges, times in json.loads(measure(sys.executable, "lidar.py")).items():
        row(f"{edges} edges", times["ours"], times["peer"], {"50": "≤ 20 µs", "1000": "≤ 80 µs"}[edges])


def scans() -> None:
    """Print the table of the grid and of matching."""
    print("\n| what | coursekit | numpy | OpenCV | goal |\n|---|---|---|---|---|")
    for name, times in json.loads(measure(sys.executable, "scans.py")).items():
        cells = [f"{times[who]:.0f} µs" if times[who] else "" for who in ("ours", "numpy", "OpenCV")]
        print(f"| {name} | {' | '.join(cells)} | {times['goal']} |")


def slam() -> None:
    """Print the table of the SLAM benchmark, if its logs are here."""
    place = folder()
    if place is None:
        print(f"\nSLAM: skipped, {MISSING}.")
        return
    others = {
        "fr079": ("≤ 0.047 m", "Cartographer 0.0452 m, GMapping 0.061 m"),
        "Intel": ("≤ 0.025 m", "Cartographer 0.0229 m, GMapping 0.070 m, MRPT rbpf-slam 0.168 m"),
    }
    head = "SLAM, median of five perturbed runs | coursekit | each run | × real time | MRPT icp-slam, unperturbed"
    print(f"\n| {head} | others, not run here | goal |\n|---|---|---|---|---|---|---|")
    for name, result in json.loads(measure(sys.executable, "slam_logs.py", str(place))).items():
        ours = f"{result['median']:.4f} m, {result['rotation']:.2f}°"
        runs = " ".join(f"{error:.4f}" for error in result["translation"])
        goal, known = others[name]
        peer = "not installed" if result["peer"] is None else f"{result['peer']:.4f} m"
        print(f"| {name} | {ours} | {runs} | {result['speed']:.0f} | {peer} | {known} | {goal}, ≥ 100 × |")


def navigation() -> None:
    """Print the row of navigation."""
    results = json.loads(measure(sys.executable, "navigation.py"))
    print("\n| random goals in the warehouse, among moving boxes | reached | collisions | driven | × real time | goal |")
    print("|---|---|---|---|---|---|")
    reached = f"{results['reached']} of {results['goals']}"
    minutes, speed = f"{results['minutes']:.0f} min", f"{results['speed']:.1f}"
    print(f"| amcl, drifting odometry | {reached} | {results['collisions']} | {minutes} | {speed} | 100 of 100, 0 |")
    for word in (*results["missed"], *results["touched"]):
        print(f"  {word}")


def viewer() -> None:
    """Print the row of the viewer."""
    ours, peer = (json.loads(measure(sys.executable, "viewer_load.py", who)) for who in ("ours", "peer"))
    theirs = "not installed" if peer is None else f"{peer:.1f} %"
    print("\n| what | coursekit, publishing and /tf included | meshcat-python and its server | goal |\n|---|---|---|---|")
    print(f"| viewer: 15 links at 30 Hz, CPU % of one core | {ours:.1f} % | {theirs} | ≤ 5 % |")


def desk() -> None:
    """Print the rows of the desk in Chromium."""
    told = json.loads(measure(sys.executable, "desk_speed.py"))
    print("\n| the desk of chapter 0, Chromium drawing in software | coursekit | goal |\n|---|---|---|")
    if told is None:
        print("| no Chromium is here | | |")
        return
    slowest = f"{told['latency']:.0f} ms, the slowest {told['slowest']:.0f} ms"
    print(f"| from a key on the pad to a picture in which the robot has moved | {slowest} | ≤ 150 ms |")
    print(f"| pictures a second while it drives and maps | {told['rate']:.1f} | ≥ 15 |")


def cpp() -> None:
    """Print the table of compiled nodes."""
    told = json.loads(measure(sys.executable, "cpp_speed.py"))
    print(
        "\n| C++ publisher to C++ subscriber, wall clock | came | median | 99 % | sender's pace | kernel, of a core | goal |"
    )
    print("|---|---|---|---|---|---|---|")
    if told is None:
        print("| no compiler is here | | | | | | |")
        return
    rows = {
        "small": ("1000 messages/s for 5 s", "none lost, pace 1"),
        "image": ("640×480×3 at 30 Hz for 5 s", "< 20 % of a core"),
    }
    for key, (what, goal) in rows.items():
        result = told[key]
        times = f"{result['median']:.0f} µs | {result['99']:.0f} µs | {result['behind']:.2f}"
        print(f"| {what} | {result['came']:.0f} | {times} | {result['core']:.0%} | {goal} |")


def between_processes() -> None:
    """Print the rows of two processes: ours over Zenoh, the real rclpy over Fast DDS with nothing but loopback."""
    ours = json.loads(measure(sys.executable, "two_processes.py", sys.executable, "ours"))
    there = alone([sys.executable, str(HERE / "two_processes.py"), str(PEER)]) if PEER.exists() else None
    peer = json.loads(subprocess.run(there, capture_output=True, encoding="utf-8", check=True).stdout) if there else {}
    head = "from one process to another | coursekit, two kernels on a router | real rclpy | ratio | goal"
    print(f"\n| {head} |\n|---|---|---|---|---|")
    row("String", ours["string"], peer.get("string"), "ahead")
    row("640×480×3 image", ours["image"], peer.get("image"), "ahead")


def main() -> None:
    """Measure ours and the real rclpy in turn and print both."""
    ours = json.loads(measure(sys.executable, "latency.py", "3000"))
    peer = json.loads(measure(PEER, "latency.py", "300")) if PEER.exists() else {}
    print("| what | coursekit | real rclpy | ratio | goal |\n|---|---|---|---|---|")
    for nodes in (2, 20, 200):
        key = f"string_{nodes}"
        row(f"String, publish → callback, {nodes} nodes", ours[key], peer.get(key), "≤ 5 µs")
    row("640×480×3 image, publish → callback", ours["image"], peer.get("image"), "≤ 50 µs")
    speed = float(measure(sys.executable, "virtual_nodes.py"))
    print(f"| twelve nodes at 30 Hz, virtual clock | {speed:.0f} × real time | has none | | ≥ 100 × |")
    viewed, unseen = json.loads(measure(sys.executable, "robot_network.py"))
    print(f"| four-robot network of chapter 7, virtual clock, with viewer | {viewed:.0f} × real time | | | ≥ 100 × |")
    print(f"| the same without viewer | {unseen:.0f} × real time | | | |")
    cpp()
    between_processes()
    lidar()
    link_poses()
    transforms()
    scans()
    viewer()
    desk()
    slam()
    navigation()
    if not peer:
        print("\nThe real rclpy is not here to compare with: `make conformance` installs it (Linux x86-64).")


if __name__ == "__main__":
    main()
