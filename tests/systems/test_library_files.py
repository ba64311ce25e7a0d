"""Whether a file is a library's or a program's."""

import os
import threading

import numpy

from coursekit.systems import library_files
from coursekit.systems.library_files import is_library_file
from tests.needs import posix


def test_the_modules_of_python_of_pip_and_of_this_package_are_shared():
    for module in (threading, numpy, library_files):
        assert is_library_file(module.__file__)


@posix("links need rights there")
def test_what_a_link_leads_to_counts(tmp_path):
    (tmp_path / "node.py").touch()
    assert not is_library_file(str(tmp_path / "node.py"))
    link = tmp_path / "linked"
    link.symlink_to(os.path.dirname(numpy.__file__))
    assert is_library_file(str(link / "__init__.py"))


def test_code_without_a_file_is_a_program_s(monkeypatch):
    monkeypatch.chdir(os.path.dirname(numpy.__file__))
    assert not is_library_file("<string>")
