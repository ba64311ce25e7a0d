"""A package as the older tutorials write it builds without a word about what newer setuptools will do some day."""

import pytest

from .test_colcon import ENV, colcon

PACKAGE = """<package format="3"><name>old</name><version>0.0.0</version><description>d</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license>
<export><build_type>ament_python</build_type></export></package>"""
SETUP = """from setuptools import setup
setup(name="old", version="0.0.0", packages=["old"], zip_safe=True, tests_require=["pytest"], license="MIT",
      classifiers=["License :: OSI Approved :: MIT License"], entry_points={"console_scripts": ["x = old:main"]},
      data_files=[("share/ament_index/resource_index/packages", ["resource/old"]), ("share/old", ["package.xml"])])
"""
CONFIG = "[develop]\nscript-dir=$base/lib/old\n[install]\ninstall-scripts=$base/lib/old\n"


@pytest.fixture
def workspace(tmp_path, monkeypatch):
    """A workspace with that package."""
    texts = {"package.xml": PACKAGE, "setup.py": SETUP, "setup.cfg": CONFIG, "old/__init__.py": "", "resource/old": ""}
    for name, text in texts.items():
        file = tmp_path / "src" / "old" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    monkeypatch.delitem(ENV, "PYTHONDONTWRITEBYTECODE", raising=False)
    return tmp_path


@pytest.mark.parametrize("words", [[], ["--symlink-install"]], ids=["copies", "links"])
def test_nothing_is_said_of_deprecations(workspace, words):
    done = colcon(workspace, "build", *words)
    assert done.returncode == 0 and "1 package finished" in done.stdout
    assert "eprecat" not in done.stdout + done.stderr and "stderr output" not in done.stdout
    assert list((workspace / "install" / "old" / "lib" / "old").iterdir())


def test_who_asks_for_warnings_gets_them(workspace, monkeypatch):
    monkeypatch.setitem(ENV, "PYTHONWARNINGS", "default")
    assert "SetuptoolsDeprecationWarning" in colcon(workspace, "build").stderr
