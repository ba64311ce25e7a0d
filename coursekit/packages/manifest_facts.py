"""`python -m coursekit.packages.manifest_facts package.xml`: the contents of a manifest as CMake variables."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from catkin_pkg.package import InvalidPackage, parse_package

from coursekit.processes.process import DISTRIBUTION

_DEPENDENCIES = {
    "BUILD_DEPENDS": "build_depends",
    "BUILDTOOL_DEPENDS": "buildtool_depends",
    "BUILD_EXPORT_DEPENDS": "build_export_depends",
    "BUILDTOOL_EXPORT_DEPENDS": "buildtool_export_depends",
    "EXEC_DEPENDS": "exec_depends",
    "TEST_DEPENDS": "test_depends",
    "GROUP_DEPENDS": "group_depends",
}


def facts(package: Any) -> Iterator[str]:
    """Yield the CMake lines for a package parsed by catkin_pkg."""
    yield _set("_AMENT_PACKAGE_NAME", [package.name])
    yield _set(f"{package.name}_VERSION", [package.version])
    yield _set(f"{package.name}_MAINTAINER", [", ".join(map(str, package.maintainers))])
    for variable, kind in _DEPENDENCIES.items():
        yield _set(f"{package.name}_{variable}", map(str, getattr(package, kind)))
    yield _set(f"{package.name}_MEMBER_OF_GROUPS", map(str, package.member_of_groups))
    deprecated = next((export.content or "TRUE" for export in package.exports if export.tagname == "deprecated"), "")
    yield _set(f"{package.name}_DEPRECATED", [deprecated] if deprecated else [])


def _set(variable: str, values: Iterable[str]) -> str:
    escaped = (re.sub(r'(["$\\])', r"\\\1", value) for value in values)
    words = " ".join(f'"{value}"' for value in escaped) or '""'
    return f"set({variable} {words})"


def main(words: list[str]) -> int:
    """Print the facts of a manifest; for an invalid one, print the reason and return 1."""
    try:
        package = parse_package(Path(words[0]))
    except (InvalidPackage, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    package.evaluate_conditions(DISTRIBUTION)
    print("\n".join(facts(package)))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
