"""Every test has secrets of its own, not those of whoever runs it; and is run by nobody special."""

import os

import pytest

from .handed import NOON


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
def same_day(monkeypatch):
    """It is a week after what was handed in, whatever this computer's clock says."""
    monkeypatch.setattr("coursekit.grade.record.now", lambda: NOON + 7 * 86400)
