"""install(...) and related commands: which files are installed where."""

from __future__ import annotations

import fnmatch
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from generate_parameter_library_py.generate_python_module import python_module

from coursekit.cpp.parameter_library import ParameterFileError, read_parameters
from coursekit.packages.cmake_run import Call, Reading

_OPTIONS = (
    "DESTINATION",
    "PERMISSIONS",
    "FILE_PERMISSIONS",
    "DIRECTORY_PERMISSIONS",
    "USE_SOURCE_PERMISSIONS",
    "CONFIGURATIONS",
    "COMPONENT",
    "RENAME",
    "OPTIONAL",
    "FILES_MATCHING",
    "PATTERN",
    "REGEX",
    "MESSAGE_NEVER",
    "TYPE",
    "EXCLUDE_FROM_ALL",
)


@dataclass(frozen=True)
class Copy:
    """One file to install: from an absolute path to a path relative to the prefix."""

    source: Path
    target: str
    program: bool = False


def copies(reading: Reading, package: str, site_packages: str) -> Iterator[Copy]:
    """Yield every file that the package installs; raises CMakeError for missing files."""
    for call in reading.calls:
        if call.command.name == "install":
            yield from _install(call)
        elif call.command.name == "ament_python_install_package":
            yield from _python_package(call, site_packages)
        elif call.command.name == "ament_auto_package" and "INSTALL_TO_SHARE" in call.words:
            for name in _until_option(call.words[call.words.index("INSTALL_TO_SHARE") + 1 :]):
                yield from _directory(call, name, f"share/{package}", [])


def _until_option(words: list[str]) -> list[str]:
    for index, word in enumerate(words):
        if word in _OPTIONS:
            return words[:index]
    return words


def _install(call: Call) -> Iterator[Copy]:
    kind, *words = call.words or [""]
    if kind not in ("FILES", "PROGRAMS", "DIRECTORY"):
        return
    destination = _after(words, "DESTINATION")
    if destination is None:
        raise call.command.error(f"install({kind} ...) needs a DESTINATION")
    target = destination.strip("/")
    for name in _until_option(words):
        if kind == "DIRECTORY":
            yield from _directory(call, name, target, words)
        else:
            yield from _file(call, name, f"{target}/{_after(words, 'RENAME') or Path(name).name}", kind, words)


def _after(words: list[str], option: str) -> str | None:
    at = words.index(option) + 1 if option in words else len(words)
    return words[at] if at < len(words) else None


def _file(call: Call, name: str, target: str, kind: str, words: list[str]) -> Iterator[Copy]:
    source = call.folder / name
    if source.is_file():
        yield Copy(source, target, kind == "PROGRAMS")
    elif "OPTIONAL" not in words:
        raise call.command.error(f"install: there is no file '{name}' in {call.folder}")


def _directory(call: Call, name: str, target: str, words: list[str]) -> Iterator[Copy]:
    source = call.folder / name
    if not source.is_dir():
        if "OPTIONAL" in words:
            return
        raise call.command.error(f"install: there is no folder '{name}' in {call.folder}")
    base = target if name.endswith("/") or name in (".", "") else f"{target}/{source.name}"
    included, excluded = _patterns(words)
    for path in sorted(p for p in source.rglob("*") if p.is_file()):
        relative = path.relative_to(source)
        if "__pycache__" in relative.parts or _matches(relative, excluded):
            continue
        if included is None or _matches(relative, included):
            yield Copy(path, f"{base}/{relative.as_posix()}")


def _patterns(words: list[str]) -> tuple[list[str] | None, list[str]]:
    included: list[str] = []
    excluded: list[str] = []
    for index, word in enumerate(words[:-1]):
        if word == "PATTERN":
            (excluded if "EXCLUDE" in words[index + 2 : index + 3] else included).append(words[index + 1])
    return (included if "FILES_MATCHING" in words else None), excluded


def _matches(path: Path, patterns: list[str]) -> bool:
    return any(fnmatch.fnmatch(part, pattern) for part in path.parts for pattern in patterns)


def _python_package(call: Call, site_packages: str) -> Iterator[Copy]:
    if not call.words:
        raise call.command.error("ament_python_install_package() needs the name of a Python package")
    name = call.words[0]
    folder = call.folder / (_after(call.words, "PACKAGE_DIR") or name)
    if not (folder / "__init__.py").is_file():
        raise call.command.error(f"there is no Python package '{name}': {folder / '__init__.py'} does not exist")
    for path in sorted(p for p in folder.rglob("*") if p.is_file() and "__pycache__" not in p.parts):
        yield Copy(path, f"{site_packages}/{name}/{path.relative_to(folder).as_posix()}")


def parameter_modules(reading: Reading) -> dict[str, str]:
    """Return the Python modules of files of parameters, by the names of their files."""
    calls = [call for call in reading.calls if call.command.name == "generate_parameter_module"]
    return dict(map(_parameter_module, calls))


def _parameter_module(call: Call) -> tuple[str, str]:
    if len(call.words) < 2:
        raise call.command.error("generate_parameter_module() needs the name of a module and a YAML file")
    file = call.folder / call.words[1]
    try:
        return f"{call.words[0]}.py", python_module(read_parameters(file), file.name, *call.words[2:3])
    except (ParameterFileError, OSError) as error:
        raise call.command.error(f"{file}: {error}") from error
