"""Copies that stand for links: renewed when their package is looked up, and never anything else than its own files."""

import os

import pytest

from coursekit.processes.executables import prefix_of
from coursekit.systems import link_copies


@pytest.fixture
def prefix(tmp_path, monkeypatch):
    """A prefix with one package, one file of which is a copy."""
    index = tmp_path / "install" / "share" / "ament_index" / "resource_index" / "packages"
    index.mkdir(parents=True)
    (index / "talks").touch()
    (tmp_path / "install" / "copy.yaml").write_text("old", encoding="utf-8")
    (tmp_path / "source.yaml").write_text("new text", encoding="utf-8")
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path / "install"))
    return tmp_path / "install"


def test_who_looks_a_package_up_gets_files_as_new_as_their_sources(prefix):
    link_copies.note(prefix, "talks", {"copy.yaml": prefix.parent / "source.yaml"})
    assert prefix_of("talks") == prefix
    assert (prefix / "copy.yaml").read_text(encoding="utf-8") == "new text"
    assert sorted(path.name for path in prefix.iterdir()) == ["copy.yaml", "share"]


def test_a_copy_that_is_newer_stays(prefix):
    source = prefix.parent / "source.yaml"
    source.write_text("NEW", encoding="utf-8")
    os.utime(source, ns=(0, 0))
    link_copies.note(prefix, "talks", {"copy.yaml": source})
    link_copies.renew(prefix, "talks")
    assert (prefix / "copy.yaml").read_text(encoding="utf-8") == "old"


def test_a_source_that_is_gone_leaves_the_copy(prefix):
    link_copies.note(prefix, "talks", {"copy.yaml": prefix / "gone.yaml"})
    link_copies.renew(prefix, "talks")
    assert (prefix / "copy.yaml").read_text(encoding="utf-8") == "old"


def test_nothing_outside_of_the_prefix_is_written(prefix):
    outside = prefix.parent / "mine.txt"
    outside.write_text("mine", encoding="utf-8")
    source = prefix.parent / "source.yaml"
    link_copies.note(prefix, "talks", {"../mine.txt": source, str(outside): source})
    link_copies.renew(prefix, "talks")
    assert outside.read_text(encoding="utf-8") == "mine"


@pytest.mark.parametrize("text", ["", "{", "[]", '{"files": 3, "modules": "x"}', '{"files": {"a": null}, "modules": {}}'])
def test_a_list_that_is_none_is_no_list(prefix, text):
    link_copies.note(prefix, "talks", {})
    (prefix / link_copies.LISTS / "talks").write_text(text, encoding="utf-8")
    link_copies.renew(prefix, "talks")
    link_copies.fresh_sources(prefix, "talks")
