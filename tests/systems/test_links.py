"""Whether links can be made is tried, not guessed from the system's name."""

import os
import shutil

from coursekit.systems.links import can_link


def test_a_refused_link_is_no_error(tmp_path, monkeypatch):
    def refuse(*_, **__):
        raise OSError(1314, "A required privilege is not held by the client")

    monkeypatch.setattr(os, "symlink", shutil.copy)
    assert can_link(tmp_path)
    monkeypatch.setattr(os, "symlink", refuse)
    assert not can_link(tmp_path)


def test_a_link_that_leads_nowhere_does_not_count(tmp_path, monkeypatch):
    monkeypatch.setattr(os, "symlink", lambda _, link: None)
    assert not can_link(tmp_path)


def test_the_trial_leaves_nothing_behind(tmp_path):
    can_link(tmp_path)
    can_link(tmp_path / "build" / "package")
    assert list(tmp_path.iterdir()) == []
