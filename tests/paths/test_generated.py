"""Whatever writes programs, scripts, descriptions or pages writes names so that they are names there, too."""

from __future__ import annotations

import ast
import html.parser
import os
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from coursekit.interfaces.parser import parse
from coursekit.interfaces.registry import make_message
from coursekit.packages.create import _refusal
from coursekit.packages.folder_name import refusal
from coursekit.packages.interface_rules import python_files
from coursekit.packages.package_settings import PackageSettings, manifest
from coursekit.packages.python_templates import setup_py
from coursekit.packages.shell_quotes import expand_quoted, quoted
from tests.needs import ON_WINDOWS, posix
from tests.paths.workspace import HOSTILE

NO_SHELL = posix("no sh reads a setup file; test_windows_quotes has cmd's")

PROGRAM = '"""+str(__import__("os").system("touch PWNED"))+"""'
NAMES = st.one_of(
    st.sampled_from([HOSTILE, PROGRAM, "C:\\Users\\Nadia", "';touch PWNED;'", '"$(touch PWNED)', "\\", "#", "*", "~", "!x"]),
    st.text(st.characters(blacklist_categories=("Cs", "Cc")), min_size=1, max_size=20),
)


def is_one_docstring(source: str) -> bool:
    """Whether a program begins with a text, and has no other expressions of its own."""
    statements = [statement for statement in ast.parse(source).body if isinstance(statement, ast.Expr)]
    return all(isinstance(statement.value, ast.Constant) for statement in statements) and len(statements) == 1


@given(NAMES)
def test_a_message_can_be_made_whatever_its_file_is_called(name: str) -> None:
    message = parse("my_msgs", "msg", "Made", "int8 x 3\nstring s 'a'", file=f"/home/{name}/msg/Made.msg")
    assert make_message(message)().x == 3


@given(NAMES)
def test_the_package_of_an_interface_says_its_name_in_a_docstring(name: str) -> None:
    text_by_file = python_files(name, [Path("a.msg"), Path("b.srv")])
    for file, text in text_by_file.items():
        assert file.endswith("py.typed") or is_one_docstring(text), text


@given(NAMES, NAMES)
def test_texts_about_a_package_are_values_in_setup_py_and_package_xml(about: str, who: str) -> None:
    recipe = PackageSettings("talks", about, about, who, f"{who}@example.com", "ament_python", node_name="talk")
    (call,) = [statement.value for statement in ast.parse(setup_py(recipe)).body if isinstance(statement, ast.Expr)]
    words = {word.arg: word.value for word in call.keywords}  # type: ignore[attr-defined]
    assert ast.literal_eval(words["description"]) == about and ast.literal_eval(words["maintainer"]) == who
    if about.isprintable() and who.isprintable():
        told = ET.fromstring(manifest(recipe))
        assert (told.findtext("description"), told.findtext("maintainer")) == (about, who)


@pytest.mark.parametrize("part", ["node_name", "library_name", "dependencies"])
def test_names_that_would_be_programs_are_refused_when_a_package_is_made(part: str) -> None:
    value = "x', __import__('os').system('touch PWNED'), '"
    given: Any = {part: (value,) if part == "dependencies" else value}
    settings = PackageSettings("talks", "", "", "", "", "ament_python", **given)
    assert "is no name of a node, a library or a package" in str(_refusal(settings, "."))
    settings = PackageSettings("talks", "", "", "", "", "cmake", ("python3-numpy",), 3, "my-node", "lib_x")
    assert _refusal(settings, "/none") is None


def shell(script: Path, *, env: dict[str, str] | None = None) -> str:
    """What sh prints after it has sourced a script."""
    command = ["sh", "-c", '. "$1"; printf "%s\\n" "$AMENT_PREFIX_PATH"', "sh", str(script)]
    done = subprocess.run(command, env=env, cwd=script.parent, capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0 and not done.stderr, done.stderr
    return done.stdout.removesuffix("\n")


@NO_SHELL
def test_a_value_in_the_environment_is_not_run_when_a_script_puts_a_folder_before_it(tmp_path: Path) -> None:
    template = Path(__import__("colcon_core").__file__).parent / "shell" / "template" / "package.sh.em"
    hook = tmp_path / "hook.sh"
    expand_quoted(template, hook, {"prefix_path": tmp_path, "hooks": []})
    with hook.open("a", encoding="utf-8") as file:
        file.write('_colcon_prepend_unique_value AMENT_PREFIX_PATH "/new"\n')
    env = {**os.environ, "AMENT_PREFIX_PATH": f"/old {HOSTILE}"}
    assert shell(hook, env=env) == f"/new:/old {HOSTILE}"
    assert not list(tmp_path.glob("PWNED*"))


@NO_SHELL
@pytest.mark.parametrize("name", [HOSTILE, PROGRAM.replace("/", ""), "a*b [c]", "end\"", "$HOME", "`x`$(y)'"])
@pytest.mark.parametrize("line", ['AMENT_PREFIX_PATH="{}"', "AMENT_PREFIX_PATH={}", 'export AMENT_PREFIX_PATH="{}"'])
def test_a_path_in_a_script_is_that_path(tmp_path: Path, name: str, line: str) -> None:
    script = tmp_path / "script.sh"
    script.write_text(quoted(line.format(f"/home/{name}") + "\n"), encoding="utf-8")
    assert shell(script) == f"/home/{name}"
    assert not list(tmp_path.glob("PWNED*"))


@NO_SHELL
@pytest.mark.parametrize("name", [HOSTILE, "end\"", "$HOME", "a\\$b`c`"])
def test_what_the_utility_of_setup_files_prints_is_run_as_values(tmp_path: Path, name: str) -> None:
    from colcon_core.shell.sh import ShShell

    install = tmp_path / name / "install"
    share = install / "talks" / "share" / "talks"
    utility = install / "_local_setup_util_sh.py"
    expand_quoted(ShShell()._get_prefix_util_template_path(), utility, {"shell_extension": ShShell()})
    share.mkdir(parents=True)
    (share / "package.dsv").write_text("prepend-non-duplicate;AMENT_PREFIX_PATH;\nsource;share/talks/more.sh\n")
    (share / "more.sh").write_text('AMENT_PREFIX_PATH="$AMENT_PREFIX_PATH;$COLCON_CURRENT_PREFIX"\n', encoding="utf-8")
    index = install / "talks" / "share" / "colcon-core" / "packages"
    index.mkdir(parents=True)
    (index / "talks").touch()
    command = [sys.executable, utility, "sh"]
    printed = subprocess.run(command, cwd=tmp_path, capture_output=True, encoding="utf-8", check=True)
    script = tmp_path / "printed.sh"
    source = '_colcon_prefix_sh_source_script() { . "$1"; }\n'
    script.write_text(source + printed.stdout, encoding="utf-8")
    env = {**os.environ, "AMENT_PREFIX_PATH": "/old"}
    assert shell(script, env=env) == f"{install}/talks:/old;{install}/talks"
    assert not list(tmp_path.rglob("PWNED*"))


@given(st.text(st.sampled_from("ab:; \n\r'"), max_size=6))
@example("a:b")
def test_folders_that_no_list_of_folders_can_name_are_refused_in_one_sentence(name: str) -> None:
    why = refusal(Path("/home", name))
    assert bool(why) == bool(set(name) & set(";\n\r" if ON_WINDOWS else ":;\n\r")) and "\n" not in why
    assert not why or why.count(". ") == 1


@posix("a folder's name holds no ':', and ';' is refused as well")
def test_colcon_refuses_such_a_folder_instead_of_building_in_it(tmp_path: Path) -> None:
    with pytest.raises(RuntimeError, match="No workspace can be in .* separates folders"):
        expand_quoted(Path("x.em"), tmp_path / "a:b" / "local_setup.sh", {})


class _Tags(html.parser.HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.found: list[tuple[str, dict[str, str | None]]] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attrs)))


def tags(page: str) -> list[tuple[str, dict[str, str | None]]]:
    """The elements of a page."""
    reader = _Tags()
    reader.feed(page)
    return reader.found


@posix("no file's name holds '<'")
def test_names_are_texts_in_pages(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    from coursekit.grade.progress import Progress
    from coursekit.grade.release import release

    name = "a'\"><script>x</script>"
    monkeypatch.setattr(Progress, "chapters", lambda self: {name: (1.0, 2.0, [(name, name, 1.0, 2.0)])})
    page = Progress.__new__(Progress)._repr_html_()
    notebook = tmp_path / "b<i>.ipynb"
    notebook.write_text('{"cells": [], "metadata": {"coursekit": {}}, "nbformat": 4, "nbformat_minor": 5}', encoding="utf-8")
    release([notebook], tmp_path / "a<script>x<")
    page_text = (tmp_path / "a<script>x<" / "page.html").read_text(encoding="utf-8")
    assert not {"script", "i"} & {tag for tag, _ in tags(page + page_text)}


def test_a_model_of_the_database_is_asked_for_by_its_name() -> None:
    from coursekit.nodes.gazebo.spawn_entity import SpawnEntityNode

    name = "a</uri></include><plugin filename='x'/>"
    asked = SimpleNamespace(args=SimpleNamespace(file=None, topic=None, database=name), log=SimpleNamespace(info=print))
    told = ET.fromstring(SpawnEntityNode._description(asked))  # type: ignore[arg-type]
    assert told.findtext("world/include/uri") == f"model://{name}"
