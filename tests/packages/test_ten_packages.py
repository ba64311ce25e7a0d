"""Ten unmodified packages in the shapes of chapters 2 to 5: built by colcon, run by `ros2 run` and `ros2 launch`."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from coursekit.packages.overlay import overlay_environment

SOURCE = Path(__file__).parents[1] / "fixtures" / "ros2_ws" / "src"
BIN = Path(sys.executable).parent

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    """The workspace, built once."""
    root = tmp_path_factory.mktemp("ten") / "ros2_ws"
    shutil.copytree(SOURCE, root / "src")
    env = {key: value for key, value in os.environ.items() if not key.startswith(("AMENT_", "COURSEKIT_"))}
    built = subprocess.run([BIN / "colcon", "build"], cwd=root, env=env, capture_output=True, encoding="utf-8", timeout=240)
    assert built.returncode == 0, built.stdout + built.stderr
    return root


def ros2(workspace, *words, stop_after=4, check=True):
    """A command after sourcing the workspace, alone on the virtual clock; (exit code, stdout and stderr)."""
    env = overlay_environment(workspace / "install", os.environ)
    env |= {"COURSEKIT_TIME": "virtual", "COURSEKIT_STOP_AFTER": str(stop_after)}
    done = subprocess.run([BIN / "ros2", *words], env=env, cwd=workspace, capture_output=True, encoding="utf-8", timeout=60)
    return done.returncode, done.stdout + done.stderr


def test_every_package_is_found_and_lists_its_executables(workspace):
    for source in sorted(SOURCE.iterdir()):
        code, prefix = ros2(workspace, "pkg", "prefix", source.name)
        assert (code, prefix.strip()) == (0, str(workspace / "install" / source.name))
    assert ros2(workspace, "pkg", "executables", "s2_py_pubsub")[1].splitlines()


def python_executables():
    """(package, executable) of every console script in the fixtures."""
    for setup in sorted(SOURCE.glob("*/setup.py")):
        for line in setup.read_text().splitlines():
            if " = " in line and ":main" in line:
                yield setup.parent.name, line.split("=")[0].strip(" '\"")


@pytest.mark.parametrize(("package", "executable"), list(python_executables()))
def test_an_executable_starts_says_something_and_ends_with_ctrl_c(workspace, package, executable):
    arguments = ["2", "3", "4"] if "client" in executable else []
    code, output = ros2(workspace, "run", package, executable, *arguments)
    assert "Traceback" not in output or "KeyboardInterrupt" in output, output
    assert code in (0, 1, -2 & 0xFF, 254), (code, output)


@pytest.mark.parametrize("file", sorted(path.name for path in SOURCE.glob("s5_bringup/launch/*")))
def test_a_launch_file_runs_and_prints_the_same_bytes_twice(workspace, file):
    one, other = (ros2(workspace, "launch", "s5_bringup", file) for _ in range(2))
    assert one == other
    assert "process started with pid" in one[1] and "process has died" not in one[1], one[1]


def test_a_built_interface_is_importable_after_sourcing(workspace):
    env = overlay_environment(workspace / "install", os.environ)
    script = "from s4_custom_interface.msg import HardwareStatus as H, Sphere as S; print(H(temperature=54), S().radius)"
    done = subprocess.run([sys.executable, "-c", script], env=env, capture_output=True, encoding="utf-8", timeout=60)
    assert done.returncode == 0 and "temperature=54" in done.stdout, done.stderr


def test_sourcing_setup_bash_gives_the_environment_that_the_lab_computes(workspace):
    if shutil.which("bash") is None:
        pytest.skip("no bash on this system")
    wanted = ("AMENT_PREFIX_PATH", "PYTHONPATH")
    bare = {"PATH": os.environ["PATH"], "HOME": str(workspace)}
    script = "source install/setup.bash && " + " && ".join(f'echo "${name}"' for name in wanted)
    done = subprocess.run(["bash", "-c", script], cwd=workspace, env=bare, capture_output=True, encoding="utf-8", timeout=60)
    computed = overlay_environment(workspace / "install", bare)
    for name, sourced in zip(wanted, done.stdout.splitlines(), strict=True):
        assert sorted(filter(None, sourced.split(":"))) == sorted(filter(None, computed.get(name, "").split(":"))), name
