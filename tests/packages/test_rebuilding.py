"""A Python module that is changed twice within a second, as cells that run one after the other do, is built both times."""

import os
import subprocess
import sys

import pytest

from coursekit.packages.overlay import overlay_environment

COLCON = [sys.executable, "-m", "colcon", "--log-base", "log", "build", "--executor", "sequential"]
SETUP = """from setuptools import find_packages, setup

setup(name="counting", version="0.0.0", packages=find_packages(), data_files=[
    ("share/ament_index/resource_index/packages", ["resource/counting"]), ("share/counting", ["package.xml"])])
"""
MANIFEST = """<package format="3"><name>counting</name><version>0.0.0</version><description>d</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license>
<export><build_type>ament_python</build_type></export></package>"""
ENV = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "PYTHONDONTWRITEBYTECODE")}
SECOND = 1_700_000_000
TENTH_NS = 100_000_000


@pytest.fixture
def package(tmp_path):
    folder = tmp_path / "src" / "counting"
    (folder / "counting").mkdir(parents=True)
    (folder / "resource").mkdir()
    (folder / "setup.py").write_text(SETUP)
    (folder / "package.xml").write_text(MANIFEST)
    (folder / "resource" / "counting").write_text("")
    (folder / "counting" / "__init__.py").write_text("")
    return folder


def test_each_of_two_changes_within_a_second_is_built_and_imported(package, tmp_path):
    module = package / "counting" / "value.py"
    printed = []
    for tenth, value in enumerate(("1", "2", "30")):  # the first two are of the same size, which bytecode is known by
        module.write_text(f"VALUE = {value}\n")
        changed = SECOND * 10**9 + (1 + tenth) * TENTH_NS
        os.utime(module, ns=(changed, changed))
        done = subprocess.run(COLCON, cwd=tmp_path, env=ENV, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
        env = overlay_environment(tmp_path / "install", ENV)
        ask = [sys.executable, "-c", "from counting.value import VALUE; print(VALUE)"]
        printed.append(subprocess.run(ask, cwd=tmp_path, env=env, capture_output=True, text=True, check=True).stdout.strip())
    assert printed == ["1", "2", "30"]
