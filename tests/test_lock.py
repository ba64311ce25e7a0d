"""The lock names one version of each package for every computer, and one that there is for it."""

from __future__ import annotations

import itertools
from importlib import metadata
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.specifiers import SpecifierSet
from packaging.version import Version

LINES = (Path(__file__).resolve().parents[1] / "requirements.lock").read_text(encoding="utf-8").splitlines()
LOCKED = [Requirement(line) for line in LINES if line and not line.startswith("#")]
COMPUTERS = [("linux", "x86_64"), ("linux", "aarch64"), ("darwin", "arm64"), ("darwin", "x86_64"), ("win32", "AMD64")]
PYTHONS = ["3.10", "3.11", "3.12", "3.13", "3.14"]
NEWEST_FOR_INTEL_MACS = {"numba": "0.62.1", "llvmlite": "0.45.1", "scipy": "1.17.1"}
"""Of packages that make none any more for these, or that Numba 0.62 does not take newer."""


def locked(computer: tuple[str, str], python: str) -> list[Requirement]:
    """What the lock names for such a computer."""
    system = {"linux": "Linux", "darwin": "Darwin", "win32": "Windows"}[computer[0]]
    facts = {
        "sys_platform": computer[0],
        "platform_machine": computer[1],
        "platform_system": system,
        "os_name": "nt" if system == "Windows" else "posix",
        "python_version": python,
        "python_full_version": f"{python}.5",
        "implementation_name": "cpython",
        "platform_python_implementation": "CPython",
    }
    return [requirement for requirement in LOCKED if requirement.marker is None or requirement.marker.evaluate(facts)]


@pytest.mark.parametrize(("computer", "python"), list(itertools.product(COMPUTERS, PYTHONS)))
def test_no_package_has_two_versions(computer: tuple[str, str], python: str) -> None:
    names = [requirement.name for requirement in locked(computer, python)]
    assert len(names) == len(set(names)) and set(NEWEST_FOR_INTEL_MACS) <= set(names)


@pytest.mark.parametrize("python", PYTHONS[:-1])
def test_a_mac_with_intel_s_processor_gets_versions_that_there_are_for_it(python: str) -> None:
    versions = {
        requirement.name: Version(str(requirement.specifier).removeprefix("=="))
        for requirement in locked(("darwin", "x86_64"), python)
    }
    assert all(versions[name] <= Version(newest) for name, newest in NEWEST_FOR_INTEL_MACS.items())


def test_other_computers_are_not_held_back_by_it() -> None:
    for computer in COMPUTERS:
        if computer != ("darwin", "x86_64"):
            assert all(
                Version(str(requirement.specifier).removeprefix("==")) > Version(NEWEST_FOR_INTEL_MACS[requirement.name])
                for requirement in locked(computer, "3.12")
                if requirement.name in NEWEST_FOR_INTEL_MACS
            )


def test_what_is_locked_for_a_python_takes_that_python() -> None:
    """As far as this environment has it; the marker of what newer Pythons get has to leave the older ones out."""
    refused = []
    for requirement, python in itertools.product(LOCKED, PYTHONS):
        is_for = requirement.marker is None or requirement in locked(("linux", "x86_64"), python)
        if is_for and (taken := pythons_of(requirement)) is not None and f"{python}.5" not in taken:
            refused.append(f"{requirement} on {python}: {taken}")
    assert not refused


def pythons_of(requirement: Requirement) -> SpecifierSet | None:
    """For which Pythons the installed package is; None where another version, or none, is installed."""
    try:
        facts = metadata.metadata(requirement.name)
    except metadata.PackageNotFoundError:
        return None
    wanted = facts.get("Requires-Python") if facts["Version"] in requirement.specifier else None
    return SpecifierSet(wanted) if wanted else None
