"""Command lines: as the shell reads them on Linux; on Windows a path keeps its backslashes."""

import shlex
import subprocess

import pytest
from hypothesis import given
from hypothesis import strategies as st

from coursekit.systems import operating_system
from coursekit.systems.command_lines import join_words, plain_words, shell_command, split_folders, split_words


@pytest.fixture
def windows(monkeypatch):
    monkeypatch.setattr(operating_system, "WINDOWS", True)


def test_on_linux_words_are_those_of_the_shell(monkeypatch):
    monkeypatch.setattr(operating_system, "WINDOWS", False)
    line = r"""run demo node --name 'a b' "c \" d" e\ f"""
    assert split_words(line) == shlex.split(line)
    assert join_words(split_words(line)) == shlex.join(shlex.split(line))


@pytest.mark.parametrize(
    ("line", "words"),
    [
        (r"run demo node C:\Users\vera\new.yaml", ["run", "demo", "node", r"C:\Users\vera\new.yaml"]),
        (r'info "C:\Users\José Luis\drive" -v', ["info", r"C:\Users\José Luis\drive", "-v"]),
        (r'info "C:\Users\José Luis\\" -v', ["info", "C:\\Users\\José Luis\\", "-v"]),
        (r"info \\server\share\drive", ["info", r"\\server\share\drive"]),
        (r"info C:\Users\O'Brien\drive", ["info", r"C:\Users\O'Brien\drive"]),
        ("pub /chat '{data: \"it\"}'", ["pub", "/chat", '{data: "it"}']),
        ("pub /chat \"{data: 'it'}\"", ["pub", "/chat", "{data: 'it'}"]),
        (r'pub /chat "{data: \"it\"}"', ["pub", "/chat", '{data: "it"}']),
        ("-p name:='a b' ''", ["-p", "name:=a b", ""]),
        ("  ", []),
    ],
)
def test_on_windows_a_backslash_is_part_of_a_path_and_both_quotes_group(windows, line, words):
    assert split_words(line) == words


@pytest.mark.parametrize("line", ['run "a', "run 'a", r'run "C:\a\"'])
def test_a_quotation_without_an_end_is_refused(windows, line):
    with pytest.raises(ValueError, match="No closing quotation"):
        split_words(line)


@given(st.lists(st.text(alphabet="aB \\\"'\t{}:é$%`", max_size=8), max_size=5))
def test_on_windows_joined_words_come_apart_again_as_they_were(words):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(operating_system, "WINDOWS", True)
        assert split_words(join_words(words)) == words


@given(st.lists(st.text(alphabet='aB \\"\t{}:é', max_size=8), max_size=5))
def test_on_windows_what_python_writes_for_programs_is_read_as_they_read_it(words):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(operating_system, "WINDOWS", True)
        assert split_words(subprocess.list2cmdline(words)) == words


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (r'"C:\a b\ros2.exe" pkg prefix "my demo"', [r"C:\a b\ros2.exe", "pkg", "prefix", "my demo"]),
        ("ros2 topic list | sort", []),
        ("ros2 run a && echo", []),
        ("echo %PATH%", []),
        ("echo 'open", []),
    ],
)
def test_on_windows_a_line_without_operators_needs_no_shell(monkeypatch, text, words):
    monkeypatch.setattr(operating_system, "WINDOWS", True)
    assert plain_words(text) == words


def test_windows_shell_is_the_one_that_the_system_names(monkeypatch):
    monkeypatch.setattr(operating_system, "WINDOWS", True)
    command = shell_command('echo "a b" && dir', {"COMSPEC": r"C:\Windows\system32\cmd.exe"})
    assert command == [r"C:\Windows\system32\cmd.exe", "/d", "/c", "echo", "a b", "&&", "dir"]


@pytest.mark.parametrize("text", [r"C:\ws\worlds;D:/more;\\server\share", r"C:\ws\worlds:D:/more:\\server\share;", ":;"])
def test_folders_that_a_package_has_joined_as_on_linux_are_told_apart_on_windows(windows, text):
    assert split_folders(text) == ([r"C:\ws\worlds", "D:/more", r"\\server\share"] if "C" in text else [])
