"""Every test has secrets of its own, not those of whoever runs it; and is run by nobody special."""

import os

import pytest

from .handed import NOON, TOPICS, cheap_mark, text, write
from .test_identifying import LISTS


@pytest.fixture(autouse=True)
def own_secrets(tmp_path_factory, monkeypatch):
    """The folder of settings of an account that did nothing yet."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path_factory.mktemp("config")))


@pytest.fixture(autouse=True)
def not_root(monkeypatch):
    """`coursekit grade` refuses root without --allow-root, as test_sandbox proves: tests are root's in a container."""
    if hasattr(os, "geteuid"):
        monkeypatch.setattr(os, "geteuid", lambda: 1000)


@pytest.fixture(autouse=True)
def marked_here(request, monkeypatch):
    """No container is asked for on Windows and macOS: what runs a student's work is made up, but in test_container."""
    if "computer" not in request.fixturenames:
        monkeypatch.setattr("coursekit.grade.container.is_needed", lambda: False)


@pytest.fixture(autouse=True)
def same_day(monkeypatch):
    """It is a week after what was handed in, whatever this computer's clock says."""
    monkeypatch.setattr("coursekit.grade.record.now", lambda: NOON + 7 * 86400)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """What Moodle's download of a class of two looks like; the list of it is beside."""
    monkeypatch.setattr("coursekit.grade.batch.mark", cheap_mark)
    monkeypatch.setattr("coursekit.grade.sandbox.tier", lambda: "bubblewrap")
    for name in LISTS:
        (tmp_path / name).write_text(LISTS[name], encoding="utf-8")
    write(tmp_path / "class" / "García López Ana_101_assignsubmission_file_" / TOPICS, text("q1", "q2"))
    return tmp_path / "class"
