"""colcon's test step for CMake packages: tests with pytest and launch_testing are run, those in C++ compiled and run."""

from __future__ import annotations

from pathlib import Path

from colcon_core.event.output import StderrLine
from colcon_core.event.test import TestFailure
from colcon_core.plugin_system import satisfies_version
from colcon_core.shell import get_command_environment
from colcon_core.task import TaskExtensionPoint, run

from coursekit.cpp.toolchain import NoToolchain, Toolchain
from coursekit.packages import cmake_build, cmake_tests
from coursekit.packages.cmake_run import Reading, read_project
from coursekit.packages.cmake_text import CMakeError
from coursekit.packages.prepare_cpp import prepared_toolchain


class FilesTestTask(TaskExtensionPoint):  # type: ignore[misc]
    """Test a CMake package; a test that cannot be run here is named."""

    def __init__(self) -> None:
        super().__init__()
        satisfies_version(TaskExtensionPoint.EXTENSION_POINT_VERSION, "^1.0")

    async def test(self) -> int:
        """Return 0, also when tests fail, which their results tell; 1 when the package cannot be read."""
        args, name = self.context.args, self.context.pkg.name
        env = await get_command_environment("test", args.build_base, self.context.dependencies)
        base = Path(args.test_result_base or args.build_base) / "test_results"
        build = Path(args.build_base)
        tools = await self._configured(build, env)
        try:
            reading = read_project(Path(args.path), testing=True)
            if tools:
                reading = cmake_tests.noted(build, reading.project) or reading
            chosen = cmake_tests.selection(args.ctest_args or [])
            tests = [test for test in cmake_tests.commands(reading, base) if chosen(test.name)]
        except (CMakeError, OSError, ValueError) as error:
            self.context.put_event_into_queue(StderrLine(f"{error}\n".encode()))
            return 1
        names = [one for one in cmake_tests.compiled(reading) if chosen(one)]
        skipped = [one for one in cmake_tests.left_out(reading) if chosen(one)]
        if names and tools and await self._make(cmake_build.build_tests(build, tools, names), env, tools):
            tests += [cmake_tests.compiled_command(one, build, base / reading.project) for one in names]
        else:
            skipped += names
        ended = [await self._run(test, env) for test in tests]
        if any(ended):
            self.context.put_event_into_queue(TestFailure(name))
        if skipped or not tests:
            print(f"Skipped tests of {name}: {', '.join(skipped) or _none(reading)}", flush=True)
        return 0

    async def _configured(self, build: Path, env: dict[str, str]) -> Toolchain | None:
        """The tools of a package that CMake has built and whose tests it has looked at; None for others."""
        if not (build / "CMakeCache.txt").is_file():
            return None
        try:
            tools = await prepared_toolchain()
        except NoToolchain as error:
            self.context.put_event_into_queue(StderrLine(f"{error}\n".encode()))
            return None
        return tools if await self._make(cmake_build.configure_tests(build, tools), env, tools) else None

    async def _make(self, command: list[str], env: dict[str, str], tools: Toolchain) -> bool:
        """Run a command of CMake; whether it went well."""
        done = await run(self.context, command, cwd=self.context.args.build_base, env=cmake_build.completed(env, tools))
        return done.returncode == 0

    async def _run(self, test: cmake_tests.TestCommand, env: dict[str, str]) -> int:
        test.results.parent.mkdir(parents=True, exist_ok=True)
        test.results.unlink(missing_ok=True)
        done = await run(self.context, test.command, cwd=self.context.args.build_base, env=env)
        cmake_tests.note_missing_result(test)
        return int(done.returncode)


def _none(reading: Reading) -> str:
    return "none has a name that --ctest-args choose" if reading.tests else "it has none"
