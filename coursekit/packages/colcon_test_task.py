"""colcon's test step for CMake packages: with ctest if CMake has built them; otherwise only their Python tests are run."""

from __future__ import annotations

import os
import sys
from pathlib import Path

from colcon_cmake.task.cmake import test as colcon_ctest
from colcon_core.event.output import StderrLine
from colcon_core.event.test import TestFailure
from colcon_core.plugin_system import satisfies_version
from colcon_core.shell import get_command_environment
from colcon_core.task import TaskExtensionPoint, run

from coursekit.cpp.toolchain import NoToolchain, Toolchain
from coursekit.files import read_text
from coursekit.packages import cmake_build, cmake_tests, cpp_hints
from coursekit.packages.cmake_run import Reading, read_project
from coursekit.packages.cmake_text import CMakeError
from coursekit.packages.prepare_cpp import prepared_toolchain


class FilesTestTask(TaskExtensionPoint):  # type: ignore[misc]
    """Test a CMake package; tests that cannot be run here are reported."""

    def __init__(self) -> None:
        super().__init__()
        satisfies_version(TaskExtensionPoint.EXTENSION_POINT_VERSION, "^1.0")

    async def test(self) -> int:
        """Return 0, even when tests fail (their results show it); another code when the package cannot be read or built."""
        if (Path(self.context.args.build_base) / "CMakeCache.txt").is_file():
            try:
                return await self._ctest(await prepared_toolchain())
            except NoToolchain as error:
                return self._fail(error)
        args = self.context.args
        env = await get_command_environment("test", args.build_base, self.context.dependencies)
        try:
            reading = read_project(Path(args.path), testing=True)
            chosen = cmake_tests.selection(args.ctest_args or [])
            depends = {dependency.name for dependency in self.context.pkg.dependencies.get("test", ())}
            tests = [test for test in cmake_tests.commands(reading, self._results(), depends) if chosen(test.name)]
        except (CMakeError, OSError, ValueError) as error:
            return self._fail(error)
        if any([await self._run(test, env) for test in tests]):
            self.context.put_event_into_queue(TestFailure(self.context.pkg.name))
        skipped = [test for test in cmake_tests.left_out(reading) if chosen(test)]
        self._tell_skipped(skipped or ([] if tests else [_none(reading)]))
        return 0

    async def _ctest(self, tools: Toolchain) -> int:
        """Build the package with BUILD_TESTING, and run ctest."""
        args = self.context.args
        build = Path(args.build_base)
        env = cmake_build.completed(await get_command_environment("build", str(build), self.context.dependencies), tools)
        code = await self._done(cmake_build.configure_tests(build, tools, self._results()), env)
        code = code or await self._build(cmake_build.build_tests(build, tools), env)
        if code:
            return code
        noted = build / "coursekit_skipped_tests.txt"
        self._tell_skipped(read_text(noted).splitlines() if noted.is_file() else [])
        colcon_ctest.CTEST_EXECUTABLE = tools.ctest
        task = colcon_ctest.CmakeTestTask()
        task.set_context(context=self.context)
        return int(await task.test() or 0)

    async def _build(self, command: list[str], env: dict[str, str]) -> int:
        """Compile; on failure, print the compiler's messages with hints."""
        listening = cmake_build.ErrorsAside(self.context)
        done = await run(listening, command, cwd=self.context.args.build_base, env=env)
        if done.returncode:
            for line in cpp_hints.with_hints(listening.errors):
                self.context.put_event_into_queue(StderrLine(line))
        return int(done.returncode)

    async def _done(self, command: list[str], env: dict[str, str], folder: Path | None = None) -> int:
        where = str(folder or self.context.args.build_base)
        return int((await run(self.context, command, cwd=where, env=env)).returncode)

    async def _run(self, test: cmake_tests.TestCommand, env: dict[str, str]) -> int:
        """Run a test like ctest: it leaves a result in any case."""
        runner = [sys.executable, "-m", "coursekit.packages.run_test", str(test.results)]
        command = [*runner, "--package-name", test.results.parent.name, "--command", *test.command]
        return await self._done(command, env, test.folder)

    def _results(self) -> Path:
        """Return the folder of all packages' test results; `--test-result-base` may set it."""
        args = self.context.args
        if args.test_result_base:
            return Path(args.test_result_base).parent  # colcon has appended the package's name
        return Path(os.path.abspath(args.build_base)) / "test_results"

    def _tell_skipped(self, names: list[str]) -> None:
        if names:
            print(f"Skipped tests of {self.context.pkg.name}: {', '.join(names)}", flush=True)

    def _fail(self, error: Exception) -> int:
        self.context.put_event_into_queue(StderrLine(f"{error}\n".encode()))
        return 1


def _none(reading: Reading) -> str:
    return "none has a name that --ctest-args choose" if reading.tests else "it has none"
