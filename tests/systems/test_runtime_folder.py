"""Sockets lie where nobody else can open them, also when somebody has taken the usual place."""

import tempfile
from pathlib import Path

import pytest

from coursekit.cli import checks
from coursekit.systems import operating_system, runtime_folder
from coursekit.systems.runtime_folder import choose, folder
from tests.needs import posix


@pytest.fixture
def short():
    """A folder of a short name: sockets have no long ones."""
    with tempfile.TemporaryDirectory(prefix="ck") as folder:
        yield Path(folder)


@pytest.fixture
def homes(short, monkeypatch):
    tmp_path = short
    for name in ("COURSEKIT_RUNTIME_DIR", "XDG_RUNTIME_DIR", "PYTEST_XDIST_WORKER"):
        monkeypatch.delenv(name, raising=False)
    (tmp_path / "tmp").mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "tmp"))
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    return tmp_path


@posix("modes and HOME are its way; tests/systems/test_rights.py looks at Windows' lists")
def test_the_runtime_folder_of_the_user_comes_first(homes, monkeypatch):
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(homes / "own"))
    assert folder() == homes / "own" / "coursekit"
    assert folder().stat().st_mode & 0o777 == 0o700


@posix("modes and HOME are its way; tests/systems/test_rights.py looks at Windows' lists")
@pytest.mark.parametrize("squat", ["open", "link", "file"])
def test_a_folder_that_somebody_else_has_taken_is_not_used_and_that_is_told(homes, squat):
    usual = folder()
    usual.rmdir()
    if squat == "open":
        usual.mkdir()
        usual.chmod(0o777)
    elif squat == "link":
        usual.symlink_to(homes)
    else:
        usual.write_text("")
    assert folder() == homes / "home" / ".cache" / "coursekit" / "run"
    assert str(usual) in choose()[1][0]
    told = checks.socket_folder()
    assert told.only_warning and str(usual) in told.fault and str(folder()) in told.cure


@posix("modes and HOME are its way; tests/systems/test_rights.py looks at Windows' lists")
def test_where_no_place_is_safe_it_says_what_to_type(homes, monkeypatch):
    (homes / "mine" / "coursekit").mkdir(parents=True)
    (homes / "mine" / "coursekit").chmod(0o755)
    monkeypatch.setenv("COURSEKIT_RUNTIME_DIR", str(homes / "mine"))
    with pytest.raises(PermissionError, match=r"can be opened by others.*export COURSEKIT_RUNTIME_DIR="):
        folder()
    assert checks.socket_folder().fault


@pytest.mark.parametrize(("mac", "most"), [(False, 107), (True, 103)])
def test_a_folder_in_which_a_socket_s_path_would_be_too_long_is_not_used(homes, monkeypatch, mac, most):
    monkeypatch.setattr(operating_system, "MAC", mac)
    monkeypatch.setattr(operating_system, "WINDOWS", False)
    monkeypatch.setattr(runtime_folder.os, "getpid", lambda: 4194304)
    monkeypatch.setenv("ROS_DOMAIN_ID", "232")
    rest = len("/coursekit/session-232-4194304")
    fits = "/tmp/" + "x" * (most - rest - len("/tmp/"))
    monkeypatch.setattr(runtime_folder.rights, "make_folder", lambda path: None)
    monkeypatch.setattr(runtime_folder.rights, "fault", lambda path: "")
    monkeypatch.setenv("COURSEKIT_RUNTIME_DIR", fits)
    assert choose()[1] == []
    monkeypatch.setenv("COURSEKIT_RUNTIME_DIR", fits + "x")
    with pytest.raises(PermissionError, match=f"would have {most + 1} bytes, and {most} are allowed"):
        choose()
