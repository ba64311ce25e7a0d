"""The doctor knows what is wrong with a computer before a student does."""

from pathlib import Path

import pytest

from coursekit.cli import checks, system_checks
from coursekit.systems import computer, operating_system


@pytest.fixture
def on_windows(monkeypatch):
    """A computer with Windows on which all is as it should be; words change it."""

    def make(**facts):
        monkeypatch.setattr(operating_system, "WINDOWS", True)
        usual = {"bits": 64, "has_long_paths": True, "runs_scripts": True, "is_from_the_store": False}
        usual |= {"is_arm_python_on_windows": False}
        for name, value in (usual | facts).items():
            monkeypatch.setattr(computer, name, lambda value=value: value)

    return make


def faults():
    return {check.name: (check.fault, check.cure, check.only_warning) for check in system_checks.run_system_checks()}


def test_where_all_is_well_nothing_is_said(on_windows, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    on_windows()
    monkeypatch.setattr(system_checks, "MOST_CHARACTERS", 1000)
    assert faults() == {}


@pytest.mark.parametrize(
    ("facts", "name", "fault", "cure"),
    [
        ({"bits": 32}, "packages", "32 bits", "64-bit"),
        ({"is_arm_python_on_windows": True}, "packages", "ARM", "64-bit"),
        ({"is_from_the_store": True}, "packages", "the Store's", "python.org"),
        ({"runs_scripts": False}, "PowerShell", r". install\setup.ps1", "Set-ExecutionPolicy"),
    ],
)
def test_each_fault_is_told_with_what_to_type(on_windows, facts, name, fault, cure):
    on_windows(**facts)
    said = faults()[name]
    assert fault in said[0] and cure in said[1]


def test_a_python_without_packages_is_no_fault_of_the_course(on_windows, monkeypatch):
    on_windows()
    monkeypatch.setattr(system_checks, "NEWEST", (3, 9))
    assert "newer than the packages" in faults()["packages"][0]


def test_a_folder_that_is_copied_elsewhere_is_told(on_windows, monkeypatch, tmp_path):
    folder = tmp_path / "OneDrive - School" / "course"
    folder.mkdir(parents=True)
    monkeypatch.chdir(folder)
    on_windows()
    assert faults()["folder"][0].startswith("OneDrive copies this folder")


def test_long_paths_matter_in_deep_folders_only(on_windows, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    on_windows(has_long_paths=False)
    monkeypatch.setattr(system_checks, "MOST_CHARACTERS", len(str(Path.cwd())))
    assert "folder" not in faults()
    monkeypatch.setattr(system_checks, "MOST_CHARACTERS", len(str(Path.cwd())) - 1)
    assert "Windows takes 260" in faults()["folder"][0]


def test_the_doctor_tells_them_with_the_others(on_windows):
    on_windows(bits=32)
    assert "packages" in [check.name for check in checks.run_all() if check.fault]
