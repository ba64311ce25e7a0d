"""The linters that packages' own tests call look at what Humble's look at."""

from pathlib import Path

import pytest
from ament_copyright.main import main
from ament_copyright.notices import LICENSES, license_of, notice_of

from coursekit.words import licenses

MIT = "".join(f"# {line}".rstrip() + "\n" for line in licenses.text("MIT").splitlines())
NOTICE = f"# Copyright 2020 Vera Course\n#\n{MIT}"
APACHE = licenses.text("Apache-2.0").rpartition("[name of copyright owner]")[2]


@pytest.fixture
def package(tmp_path, monkeypatch):
    """A package whose sources have their notice, and a setup.py that has none."""
    for name, text in {"package.xml": "<package/>", "setup.py": "x = 1\n", "a/node.py": NOTICE, "a/__init__.py": ""}.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_setup_py_beside_package_xml_needs_no_notice(package, capsys):
    assert main([".", "a"]) == 0
    assert capsys.readouterr().out == "No problems found, checked 2 files\n"


def test_setup_py_elsewhere_needs_one(package, capsys):
    (package / "a" / "setup.py").write_text("x = 1\n")
    assert main(argv=["."]) == 1
    said = capsys.readouterr()
    assert said.err == f"{Path('a/setup.py')}: could not find copyright notice\n1 errors, checked 3 files\n"
    assert said.out == ""


@pytest.mark.parametrize("folder", ["_build", ".hidden", "ignored"])
def test_hidden_and_ignored_folders_are_not_looked_into(package, folder):
    (package / folder / "deep").mkdir(parents=True)
    (package / folder / "deep" / "x.py").write_text("x = 1\n")
    assert main(argv=["."]) == int(folder == "ignored")
    (package / folder / "AMENT_IGNORE").touch()
    assert main(argv=["."]) == 0


def test_a_file_that_is_named_is_looked_at(package):
    assert main(["setup.py"]) == 1 and main(["a/node.py"]) == 0


@pytest.mark.parametrize(
    ("source", "said"),
    [
        ("# Copyright 2020 Vera\n# Licensed under the Apache License, Version 2.0.\n", "Vera (2020), license=<unknown>"),
        ("// Copyright (c) 2019-2021, Vera, Inc.\n", "Vera, Inc. (2019-2021), license=<unknown>"),
        ("#!/usr/bin/env python3\n# -*- coding: utf-8 -*-\n" + NOTICE, "Vera Course (2020), license=mit"),
        ("/* Copyright 2018, 2020 X\n */\n", None),
        ("x = 'Copyright 2020 Vera'\n", None),
    ],
)
def test_a_notice_is_a_comment_with_years_and_a_holder(source, said, package, capsys):
    (package / "a" / "node.py").write_text(source)
    main(["--verbose", "a/node.py"])
    told = capsys.readouterr()
    expected = f"copyright={said}" if said else "could not find copyright notice"
    assert (told.out + told.err).startswith(f"{Path('a/node.py')}: {expected}\n")


@pytest.mark.parametrize("mark", ["# ", "// ", "/// ", " * "])
@pytest.mark.parametrize(
    ("file", "name"),
    [
        *(("BSL-1.0", "boost1"), ("BSD-2-Clause", "bsd_2clause"), ("BSD-3-Clause", "bsd_3clause")),
        *(("MIT", "mit"), ("MIT-0", "mit0"), ("Apache-2.0", "apache2")),
    ],
)
def test_a_license_is_known_in_every_kind_of_comment(mark, file, name):
    words = APACHE if file == "Apache-2.0" else licenses.text(file)
    lines = "".join(f"{mark}{line}".rstrip() + "\n" for line in ["Copyright 2020 Vera Course", "", *words.splitlines()])
    notice = notice_of(f"/*\n{lines} */\n" if mark == " * " else lines + "\nx = 1\n")
    assert (notice.holders, notice.license) == (["Vera Course (2020)"], name)


def test_the_names_of_bsd_s_holder_and_the_marks_of_its_list_may_be_others():
    words = licenses.text("BSD-3-Clause").replace("the copyright holder nor", "Vera Inc. nor").replace("1. ", " * ")
    assert license_of(words) == "bsd_3clause" and license_of(words.replace("modification", "change")) == "<unknown>"


def test_licenses_are_listed(capsys):
    assert main(["--list-licenses"]) == 0
    assert capsys.readouterr().out.splitlines()[0] == "apache2: Apache License, Version 2.0"
    assert len(LICENSES) == 9
