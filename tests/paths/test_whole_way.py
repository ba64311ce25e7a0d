"""A workspace's and a course's whole way in folders whose names hold quotes and commands: all works, nothing is run."""

from __future__ import annotations

import ast
import json
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from jupyter_client.manager import KernelManager

from coursekit.cli.coursekit import main
from coursekit.cli.lab import lab_environment
from coursekit.cli.terminal_settings import terminal_settings
from tests.grade.attacks import RIGHT
from tests.grade.test_attacks import cells
from tests.needs import posix
from tests.paths import workspace
from tests.paths.workspace import HOSTILE, type_in

pytestmark = [pytest.mark.slow, pytest.mark.timeout(240)]
typed = posix("bash reads what is typed there")


@pytest.fixture(scope="module", params=["copied", "linked"])
def built(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A workspace in such a folder, built."""
    folder = tmp_path_factory.mktemp("paths") / HOSTILE / f"ws {HOSTILE}"
    workspace.make(folder)
    said = type_in(folder, "colcon build $1", "--symlink-install" if request.param == "linked" else "")
    assert "2 packages finished" in said, said
    return folder


@pytest.fixture(autouse=True)
def nothing_is_run(tmp_path_factory: pytest.TempPathFactory):
    """No command in a name was carried out, by any step."""
    yield
    assert not [*tmp_path_factory.getbasetemp().rglob("PWNED*"), *Path.cwd().glob("PWNED*")]


@typed
def test_setup_files_lead_to_the_workspace_in_each_shell(built: Path) -> None:
    for shell in ("bash", "sh"):
        said = type_in(built, f'{shell} -c ". ./install/setup.{shell} && ros2 pkg prefix talks && ros2 run talks talk" 2>&1')
        assert str(built / "install" / "talks") in said and "told by the ñ's" in said, said


@typed
def test_a_workspace_that_is_sourced_on_another_finds_both(built: Path, tmp_path: Path) -> None:
    above = tmp_path / HOSTILE
    (above / "src").mkdir(parents=True)
    type_in(above, 'cd src; ros2 pkg create above --build-type ament_python --maintainer-email ada@example.com')
    type_in(above, '. "$1/install/setup.bash"; colcon build', str(built))
    said = type_in(above, ". install/setup.bash; ros2 pkg prefix talks; ros2 pkg prefix above")
    assert said.splitlines() == [str(built / "install" / "talks"), str(above / "install" / "above")]


@typed
def test_launch_files_start_it_and_a_map_is_loaded_and_saved(built: Path) -> None:
    said = type_in(built, ". install/setup.bash; ros2 launch talks all.launch.py")
    assert "told by the ñ's" in said and "Map saved" in said and "got segment wheel" in said, said
    picture = (built / "saved room.pgm").read_bytes()
    assert picture.endswith(bytes([0, 254, 254, 254, 254, 0]))


@typed
@pytest.mark.parametrize("file", ["pair.launch.xml", "whole.launch.yaml"])
def test_launch_files_in_xml_and_yaml_start_it(built: Path, file: str) -> None:
    said = type_in(built, '. install/setup.bash; ros2 launch talks "$1"', file)
    share = built / "install" / "talks" / "share" / "talks"
    assert "told by the ñ's" in said and f"included from {share}" in said, said
    assert said.count(f"{share}/room.yaml") >= 1, said


@typed
def test_a_bag_is_recorded_told_and_played(built: Path) -> None:
    lines = '. install/setup.bash; ros2 launch "$1" bag:="$2"; ros2 bag info "$2"; ros2 bag play "$2"'
    file = built / "record.launch.py"
    file.write_text(_RECORD, encoding="utf-8")
    said = type_in(built, lines, str(file), str(built / f"bag {HOSTILE}"))
    assert "Type: talks_msgs/msg/Count" in said and f"Opened database '{built}" in said, said


_RECORD = '''
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument("bag"),
        Node(package="talks", executable="talk"),
        ExecuteProcess(cmd=["ros2", "bag", "record", "-a", "-o", LaunchConfiguration("bag")]),
    ])
'''


@pytest.fixture(scope="module")
def course(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the course in such a folder, with a notebook of one exercise that is solved."""
    folder = tmp_path_factory.mktemp("course") / HOSTILE / f"course {HOSTILE}"
    assert main(["course", "--folder", str(folder)]) == 0
    (folder / "names.ipynb").write_text(json.dumps(cells(RIGHT)), encoding="utf-8")
    return folder


@pytest.fixture
def kernel(course: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[str], str]]:
    """A kernel as `coursekit lab` starts it in that course, on the virtual clock; kernel("code") gives what that prints."""
    monkeypatch.setenv("COURSEKIT_TIME", "virtual")
    env = lab_environment(course)
    monkeypatch.setenv("JUPYTER_PATH", env["JUPYTER_PATH"])
    manager = KernelManager(kernel_name="python3")
    manager.start_kernel(env=env, cwd=str(course))
    client = manager.client()
    client.start_channels()
    client.wait_for_ready(timeout=60)

    def run(code: str) -> str:
        said: list[dict[str, Any]] = []
        client.execute_interactive(code, timeout=100, output_hook=lambda message: said.append(message["content"]))
        errors = ["\n".join(output["traceback"]) for output in said if "traceback" in output]
        shown = [output["data"].get("text/plain", "") for output in said if "data" in output]
        return "".join(output.get("text", "") for output in said) + "".join([*shown, *errors])

    yield run
    client.stop_channels()
    manager.shutdown_kernel(now=True)


def test_a_course_is_worked_in_and_handed_in(course: Path, kernel: Callable[[str], str]) -> None:
    said = kernel("import os; os.makedirs('ros2_ws/src', exist_ok=True); os.chdir('ros2_ws/src')") + kernel(
        "%ros2 pkg create talks --build-type ament_python --node-name talk --maintainer-email ada@example.com"
    )
    assert "creating" in said, said
    assert "1 package finished" in kernel("%colcon build --symlink-install"), said
    assert "Hi from talks" in kernel("%ros2 run talks talk")
    said = kernel("%ros2 run talks talk --ros-args --params-file {workspace()}/src/talks/package.xml -r a:={workspace()}")
    assert "Hi from talks" in said, said
    assert "setup.py" in kernel("%show src/talks")
    kernel("%%write src/words.txt\nhello")
    assert (course / "ros2_ws" / "src" / "words.txt").read_text(encoding="utf-8") == "hello\n"
    assert "Wrote evidence/AdaLovelace_evidence_s2.png" in kernel("evidence('s2', 'words', by='Ada Lovelace')")
    said = kernel(f"os.chdir({str(course)!r}); hand_in('names.ipynb')")
    assert "AdaLovelace_names.zip (1 of 1 points in a clean run)" in said, said
    assert main(["verify", str(course / "AdaLovelace_names.zip"), "--notebooks", str(course)]) == 0


@posix("its terminals are PowerShell's")
def test_terminals_of_the_course_begin_in_its_folder_with_its_commands(course: Path) -> None:
    (setting,) = terminal_settings(course)
    words = ast.literal_eval(setting.partition("=")[2])["shell_command"]
    said = subprocess.run(
        [*words[:-1], "-i", "-c", "pwd; command -v ros2"],
        env=lab_environment(course),
        cwd="/",
        stdin=subprocess.DEVNULL,
        capture_output=True,
        encoding="utf-8",
        check=True,
    ).stdout
    assert said.splitlines() == [str(course), str(workspace.BIN / "ros2")]


@posix("no folder has a colon in its name")
def test_a_course_in_a_folder_that_no_list_can_name_is_refused_in_a_sentence(tmp_path: Path) -> None:
    with pytest.raises(SystemExit, match="No workspace can be in '.*a:b': ':' separates folders .* coursekit lab --folder"):
        main(["course", "--folder", str(tmp_path / "a:b")])
    assert not list(tmp_path.iterdir())
