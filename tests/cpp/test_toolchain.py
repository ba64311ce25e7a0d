"""Where C++ cannot be compiled, it is said why and what to type; nothing is promised that does not help there."""

import pytest

from coursekit.cli import checks
from coursekit.cpp.toolchain import NoToolchain, find_toolchain
from coursekit.systems import which


@pytest.fixture
def on_windows(monkeypatch):
    """What is found on Windows; what was found on this computer is forgotten, before and after."""
    find_toolchain.cache_clear()
    monkeypatch.setattr(which, "WINDOWS", True)
    yield
    find_toolchain.cache_clear()


def test_on_windows_wsl_is_named_and_no_package_that_would_not_help(on_windows):
    with pytest.raises(NoToolchain, match="not compiled on Windows.*wsl --install") as refused:
        find_toolchain()
    assert "coursekit[cpp]" not in str(refused.value)


def test_the_doctor_says_so_and_finds_no_fault(on_windows):
    check = checks.cpp_tools()
    assert "wsl --install" in check.finding and check.fault == ""
