"""Every test has secrets of its own, not those of whoever runs it."""

import pytest


@pytest.fixture(autouse=True)
def own_secrets(tmp_path_factory, monkeypatch):
    """The folder of settings of an account that did nothing yet."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path_factory.mktemp("config")))
