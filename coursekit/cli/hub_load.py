"""Measure the cost of one student: a Jupyter server, a kernel and the simulation of chapter 8."""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import psutil
from jupyter_client.kernelspec import KernelSpecManager
from jupyter_client.manager import KernelManager

from .kernel_sockets import takes_sockets
from .lab import lab_environment, lab_options

MB = 1 << 20
START_S = 120.0
"""The timeout for the start of a server or a kernel [s]."""
SECONDS = 10
"""How long the simulation is measured [s]."""
_ROBOT = """
import shutil
from pathlib import Path
from ament_index_python.packages import get_package_share_directory
_cart = Path(get_package_share_directory("coursekit_robots")) / "urdf" / "robot_lidar.urdf"
%ros2 launch gazebo_ros gazebo.launch.py world:=tec_warehouse &
%ros2 run robot_state_publisher robot_state_publisher {_cart} --ros-args -p use_sim_time:=true &
%ros2 run gazebo_ros spawn_entity.py -entity robot_lidar -file {_cart} -x 0.5 -y 0.5
%ros2 launch slam_toolbox online_async_launch.py &
%ros2 topic pub -r 10 /cmd_vel geometry_msgs/msg/Twist "{linear: {x: 0.3}, angular: {z: 0.4}}" &
"""
"""The robot of chapter 8, driving in circles and mapping."""


class NotMeasured(RuntimeError):
    """A server, a kernel or the simulation does not start; the message suggests what to try."""


@dataclass(frozen=True)
class Load:
    """The measured values."""

    server_mb: float
    """The memory of the Jupyter server."""
    kernel_mb: float
    """The memory of an idle kernel."""
    busy_mb: float
    """The memory of a kernel that simulates a robot and maps."""
    cores: float
    """The processor load of that kernel in cores: 0.3 is a third of one core."""
    server_s: float
    kernel_s: float
    """The start times of both [s]."""

    def student_mb(self) -> float:
        """Return the memory of a student who runs a simulation."""
        return self.server_mb + self.busy_mb


def measure() -> Load:
    """Start the programs of a hub's student in a temporary course, measure them, and end them.

    Raises:
        NotMeasured: when a server, a kernel or the simulation does not start.
    """
    with tempfile.TemporaryDirectory(prefix="ck-hub-") as name:
        folder = Path(name)
        (folder / "ros2_ws" / "src").mkdir(parents=True)
        env = lab_environment(folder) | {"COURSEKIT_RUNTIME_DIR": str(folder / "run")}
        with _server(folder, env) as (process, server_s):
            server_mb = _memory_mb(process.pid)
        return _with_kernel(folder, env, server_mb, server_s)


@contextmanager
def _server(folder: Path, env: dict[str, str]) -> Iterator[tuple[subprocess.Popen[bytes], float]]:
    """Run a Jupyter server that listens on a socket in the folder; no port is opened."""
    began, socket = time.monotonic(), folder / "server.sock"
    command = [sys.executable, "-m", "jupyter", "lab", "--no-browser", f"--ServerApp.sock={socket}", *lab_options(folder)]
    quiet = subprocess.DEVNULL
    process = subprocess.Popen(command, env=env, cwd=folder, stdin=quiet, stdout=quiet, stderr=quiet)
    try:
        while not socket.exists():
            if process.poll() is not None or time.monotonic() - began > START_S:
                raise NotMeasured("the Jupyter server does not start: try `coursekit lab --no-browser`, which says why")
            time.sleep(0.05)
        yield process, time.monotonic() - began
    finally:
        process.terminate()
        process.wait()


def _with_kernel(folder: Path, env: dict[str, str], server_mb: float, server_s: float) -> Load:
    began = time.monotonic()
    specs = KernelSpecManager(kernel_dirs=[str(folder / ".coursekit" / "jupyter" / "kernels")], ensure_native_kernel=False)
    transport = "ipc" if takes_sockets(folder) else "tcp"
    kernel = KernelManager(kernel_name="python3", kernel_spec_manager=specs, transport=transport)
    kernel.connection_file = str(folder / "kernel.json")
    kernel.start_kernel(env=env, cwd=str(folder))
    client = kernel.client()
    client.start_channels()
    try:
        client.wait_for_ready(timeout=START_S)
        _run(client, "print()")
        kernel_s = time.monotonic() - began
        process = psutil.Process(int(getattr(kernel.provisioner, "pid", 0)))
        idle_mb = _memory_mb(process.pid)
        _run(client, _ROBOT)
        before = _used_s(process)
        time.sleep(SECONDS)
        cores = (_used_s(process) - before) / SECONDS
        return Load(server_mb, idle_mb, _memory_mb(process.pid), cores, server_s, kernel_s)
    except (RuntimeError, TimeoutError) as error:
        raise NotMeasured(f"a kernel or its simulation does not start: {error}") from None
    finally:
        client.stop_channels()
        kernel.shutdown_kernel(now=True)


def _run(client: Any, code: str) -> None:
    reply = client.execute_interactive(code, timeout=START_S, output_hook=lambda _: None)["content"]
    if reply["status"] != "ok":
        raise RuntimeError(f"{reply['ename']}: {reply['evalue']}")


def _used_s(process: psutil.Process) -> float:
    times = process.cpu_times()
    return float(times.user + times.system)


def _memory_mb(pid: int) -> float:
    """Return the memory that ending the process and its children would free: shared memory is not counted."""
    top = psutil.Process(pid)
    return sum(float(child.memory_full_info().uss) for child in (top, *top.children(recursive=True))) / MB
