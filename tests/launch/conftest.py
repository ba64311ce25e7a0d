"""A virtual session, a launch in it, and packages made for one test."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from launch import LaunchContext, LaunchDescription, LaunchService
from launch.logging import reset

from coursekit.processes.session import Session
from tests.launch.show import SHOW, Arguments

HEADER_LINES = 2


@dataclass
class Result:
    """What a launch returned and printed, without the two lines it begins with."""

    code: int | None
    lines: list[str]
    service: Any = None

    @property
    def text(self) -> str:
        return "\n".join(self.lines)


@pytest.fixture
def session(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Session]:
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path / "log"))
    with Session(virtual=True).use() as virtual_session:
        reset()
        yield virtual_session


@pytest.fixture
def context(session: Session) -> LaunchContext:
    return LaunchContext()


@pytest.fixture
def launch(session: Session) -> Callable[..., Result]:
    """Return a function that launches entities in a process of the session, to the end."""

    def run(
        entities: Iterable[Any],
        *,
        interrupt_after: float | None = None,
        meanwhile: Callable[[LaunchService], None] | None = None,
        **options: Any,
    ) -> Result:
        services: list[LaunchService] = []

        def main() -> int:
            service = LaunchService(**options)
            services.append(service)
            service.include_launch_description(LaunchDescription(list(entities)))
            return service.run()

        process = session.start(main, name="launch")
        if meanwhile is not None:
            session.spawn(lambda: meanwhile(services[0]))
        if interrupt_after is not None:
            session.clock.sleep(interrupt_after)
            process.interrupt()
        code = process.wait()
        return Result(code, process.output.splitlines()[HEADER_LINES:], services[0] if services else None)

    return run


class Workspace:
    """An ament prefix with packages that a test fills."""

    def __init__(self, prefix: Path) -> None:
        self.prefix = prefix

    def package(self, name: str) -> Path:
        """Make a package; return its share folder."""
        index = self.prefix / "share/ament_index/resource_index/packages"
        index.mkdir(parents=True, exist_ok=True)
        (index / name).touch()
        share = self.prefix / "share" / name
        share.mkdir(exist_ok=True)
        (share / "package.xml").write_text(f"<package><name>{name}</name></package>")
        return share

    def file(self, package: str, name: str, text: str) -> Path:
        """Put a file into a package's share folder."""
        path = self.package(package) / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def executable(self, package: str, name: str, text: str) -> Path:
        """Make a Python executable of a package."""
        self.package(package)
        path = self.prefix / "lib" / package / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("#!/usr/bin/env python3\n" + text)
        path.chmod(0o755)
        return path


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Workspace:
    prefix = tmp_path / "install"
    others = os.environ.get("AMENT_PREFIX_PATH")
    monkeypatch.setenv("AMENT_PREFIX_PATH", f"{prefix}{os.pathsep}{others}" if others else str(prefix))
    return Workspace(prefix)


@pytest.fixture
def show(launch: Callable[..., Result], workspace: Workspace) -> Arguments:
    """Return a function that launches entities and tells the argv of the nodes in them."""
    workspace.executable("demo", "show", SHOW)

    def run(*entities: Any) -> list[str]:
        result = launch(entities)
        assert result.code == 0, result.text
        return [line.split("ARGV ")[1] for line in result.lines if "ARGV " in line]

    return run


TALKER = """
import sys
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('text', 'hello')
        self.declare_parameter('rate', 1.0)
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_timer(1.0 / self.get_parameter('rate').value, self.talk)
        self.count = 0

    def talk(self):
        text = f"{self.get_parameter('text').value} {self.count}"
        self.get_logger().info(f'Publishing: "{text}" on {self.publisher.topic_name}')
        self.publisher.publish(String(data=text))
        self.count += 1


def main():
    rclpy.init()
    node = Talker()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass


main()
"""


@pytest.fixture
def talker(workspace: Workspace) -> Workspace:
    """A workspace with package `demo` and its executable `talker`."""
    workspace.executable("demo", "talker", TALKER)
    return workspace
