"""colcon's build step for CMake packages: with CMake and a compiler, if a package needs them and they are available.

Other packages, and those with C++ without a compiler, are read by coursekit: files and interfaces are installed.
"""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any

from colcon_core.environment import create_environment_scripts
from colcon_core.event.output import StderrLine
from colcon_core.plugin_system import satisfies_version
from colcon_core.python_install_path import get_python_install_path
from colcon_core.shell import create_environment_hook, get_command_environment
from colcon_core.task import TaskExtensionPoint, create_file, install

from coursekit.cpp.runtime import ROOM
from coursekit.cpp.toolchain import NoToolchain, Toolchain, cache_folder
from coursekit.files import read_text
from coursekit.interfaces.errors import InterfaceError
from coursekit.interfaces.idl import is_translated
from coursekit.interfaces.stubs import package_stubs
from coursekit.packages import cmake_build, cpp_hints, cpp_limits, install_rules, interface_rules
from coursekit.packages.cmake_beyond import NeedsCMake
from coursekit.packages.cmake_run import Reading, read_project
from coursekit.packages.cmake_text import CMakeError
from coursekit.packages.colcon_links import stands_for_links
from coursekit.packages.folder_name import cpp_refusal
from coursekit.packages.local_setup import local_setup_files
from coursekit.packages.prepare_cpp import prepared_toolchain
from coursekit.processes.executables import stand_ins
from coursekit.systems import link_copies

PACKAGE_TYPE = "ros.ament_cmake_files"
_NAME = re.compile(r"[a-zA-Z0-9][a-zA-Z0-9_-]*")
_INDEX = "share/ament_index/resource_index"


class FilesBuildTask(TaskExtensionPoint):  # type: ignore[misc]
    """Build a CMake package: install what needs no compiler, and report what was left out."""

    def __init__(self) -> None:
        super().__init__()
        satisfies_version(TaskExtensionPoint.EXTENSION_POINT_VERSION, "^1.0")

    async def build(self) -> int:
        """Return 0, or 1 when a file is missing or an interface is invalid."""
        package = self.context.pkg.name
        if "manifest_error" in self.context.pkg.metadata:
            return self._fail([ValueError(self.context.pkg.metadata["manifest_error"])])
        if not _NAME.fullmatch(package):  # it is used as the name of folders and of a Python package
            return self._fail([ValueError(f"{package!r} is no package name: use small letters, digits and _")])
        self._installed: list[str] = []
        self._copied: dict[str, Path] = {}
        if not cmake_build.needs_compiler(Path(self.context.args.path)):
            try:
                return await self._copy_files("", strict=True)
            except NeedsCMake as error:
                return await self._hand_to_cmake(error)
        if why := self._refusal():
            return await self._copy_files(why)
        try:
            tools = await prepared_toolchain()
        except NoToolchain as error:
            return await self._copy_files(str(error))
        return await self._compile(tools)

    async def _hand_to_cmake(self, error: NeedsCMake) -> int:
        """Build the package with CMake; if CMake is missing, fail instead of silently leaving files out."""
        try:
            tools = await prepared_toolchain()
        except NoToolchain:
            return self._fail([error])
        if why := self._refusal():
            return self._fail([error, ValueError(why)])
        return await self._compile(tools)

    def _refusal(self) -> str:
        """Return why CMake cannot build here; empty when it can."""
        args = self.context.args
        return cpp_refusal(*map(Path, (args.path, args.build_base, args.install_base)), ROOM, cache_folder())

    async def _copy_files(self, why: str, *, strict: bool = False) -> int:
        args, package = self.context.args, self.context.pkg.name
        try:
            env = await get_command_environment("build", args.build_base, self.context.dependencies)
            reading = read_project(Path(args.path), strict=strict)
            problems = interface_rules.check(package, reading, self._groups(), _prefixes(env))
            if problems:
                return self._fail(problems)
            self._install(package, reading)
        except NeedsCMake:
            raise
        except (CMakeError, InterfaceError, RuntimeError, OSError) as error:
            return self._fail([error])
        self._finish(package, reading.targets, why)
        return 0

    async def _compile(self, tools: Toolchain) -> int:
        package, left_out = self.context.pkg.name, dict[str, str]()
        while True:
            code, told = await cmake_build.build_with_cmake(self.context, tools, left_out)
            unavailable = self._unavailable(told.of_targets) if code else {}
            if unavailable.keys() <= left_out.keys():
                break
            left_out |= unavailable
        if code and (why := self._why(told.errors)):
            return await self._copy_files(why)
        for line in cpp_hints.with_hints(told.errors) if code else told.errors:
            self.context.put_event_into_queue(StderrLine(line))
        if code == 0:
            self._installed = cmake_build.installed(Path(self.context.args.build_base), Path(self.context.args.install_base))
            self._note_skipped(package, left_out)
            self._finish(package, list(left_out), "; ".join(dict.fromkeys(left_out.values())))
            if stands_for_links():
                print(f"{package} is copied: build it again after every change of a file", flush=True)
        return code

    def _unavailable(self, errors: Mapping[str, list[bytes]]) -> dict[str, str]:
        """Return the targets that failed because something is missing here, with the reasons."""
        return {target: why for target, lines in sorted(errors.items()) if (why := self._why(lines))}

    def _why(self, errors: list[bytes]) -> str:
        said = b"".join(errors).decode(errors="replace")
        return cpp_limits.reason(said, self._depends(), bool(stand_ins(self.context.pkg.name)))

    def _depends(self) -> set[str]:
        return {dependency.name for kind in self.context.pkg.dependencies.values() for dependency in kind}

    def _fail(self, problems: list[Exception]) -> int:
        for problem in problems:
            self.context.put_event_into_queue(StderrLine(f"{problem}\n".encode()))  # colcon expects bytes
        return 1

    def _groups(self) -> list[str]:
        return list(self.context.pkg.metadata.get("member_of_groups", []))

    def _install(self, package: str, reading: Reading) -> None:
        site = self._site_packages()
        files = interface_rules.interface_files(reading)
        for path in files:
            target = f"share/{package}/{path.suffix[1:]}/{path.name}"
            if is_translated(path):  # it is deleted with this interpreter
                self._create(target, read_text(path))
            else:
                self._copy(path, target)
        if files:
            self._create(f"{_INDEX}/rosidl_interfaces/{package}", "".join(f"{p.suffix[1:]}/{p.name}\n" for p in files))
            text_by_name = {**interface_rules.python_files(package, files), **package_stubs(package, files)}
            for name, text in text_by_name.items():
                self._create(f"{site}/{name}", text)
            for name, text in interface_rules.cpp_files(package, files).items():
                self._create(f"include/{package}/{name}", text)
        for copy in install_rules.copies(reading, package, site):
            self._copy(copy.source, copy.target, copy.program)
            self._copied[copy.target] = Path(os.path.abspath(copy.source))
        for name, text in install_rules.parameter_modules(reading).items():
            self._create(f"{site}/{package}/{name}", text)
        for name, text in reading.hooks.items():
            known = text.replace("@CMAKE_INSTALL_PREFIX@", self.context.args.install_base)
            self._create(f"share/{package}/environment/{name}", known)
        if (Path(self.context.args.path) / "package.xml").is_file():
            self._copy(Path(self.context.args.path) / "package.xml", f"share/{package}/package.xml")
        self._create(f"{_INDEX}/packages/{package}", "")
        if not reading.targets:
            config = cmake_build.package_config(package, interface_rules.exported_dependencies(reading))
            self._create(f"share/{package}/cmake/{package}Config.cmake", config)
        self._note_skipped(package, reading.targets)

    def _note_skipped(self, package: str, targets: Collection[str]) -> None:
        """Let `ros2 run` explain why an executable is missing."""
        if targets:
            self._create(f"{_INDEX}/coursekit_skipped/{package}", "".join(f"{target}\n" for target in targets))

    def _note_copies(self, package: str) -> None:
        """Record copies made instead of refused links, to update them without a build."""
        prefix = Path(self.context.args.install_base)
        if stands_for_links():
            link_copies.note(prefix, package, self._copied)
        else:
            link_copies.forget(prefix, package)

    def _site_packages(self) -> str:
        base = Path(self.context.args.install_base)
        path = get_python_install_path("purelib", {"base": str(base), "platbase": str(base)})
        return os.path.relpath(path, base)

    def _copy(self, source: Path, target: str, program: bool = False) -> None:
        args = self.context.args
        install(args, os.path.relpath(source, args.path), target)
        if program:
            path = Path(args.install_base) / target
            path.chmod(path.stat().st_mode | 0o111)
        self._installed.append(target)

    def _create(self, target: str, text: str) -> None:
        path = Path(self.context.args.install_base) / target
        if path.is_symlink():
            path.unlink()
        create_file(self.context.args, target, content=text)
        self._installed.append(target)

    def _finish(self, package: str, skipped: list[str], why: str) -> None:
        args = self.context.args
        self._note_copies(package)
        self._forget_old()
        hooks = create_environment_hook(
            "ament_prefix_path", Path(args.install_base), package, "AMENT_PREFIX_PATH", "", mode="prepend"
        )
        own = [file for file in self._installed if Path(file).parent.as_posix() == f"share/{package}/environment"]
        create_environment_scripts(self.context.pkg, args, additional_hooks=[*hooks, *own])
        for name, text in local_setup_files(Path(args.install_base), package).items():
            create_file(args, name, content=text)
        if skipped:
            ours = [path.name for path in stand_ins(package)]
            instead = f"; coursekit's own {', '.join(sorted(ours))} answer in their place" if ours else ""
            names = ", ".join(skipped)
            print(f"Skipped C++ of {package}: {names} ({why}; the rest is installed{instead})", flush=True)

    def _forget_old(self) -> None:
        """Remove files installed by the last build but not by this one."""
        manifest = Path(self.context.args.build_base) / "coursekit_install_manifest.txt"
        manifest.parent.mkdir(parents=True, exist_ok=True)
        old = read_text(manifest).splitlines() if manifest.is_file() else []
        for target in set(old) - set(self._installed):
            (Path(self.context.args.install_base) / target).unlink(missing_ok=True)
        manifest.write_text("".join(f"{name}\n" for name in self._installed), encoding="utf-8")


def _prefixes(env: dict[str, Any]) -> list[Path]:
    return [Path(p) for p in env.get("AMENT_PREFIX_PATH", "").split(os.pathsep) if p]
