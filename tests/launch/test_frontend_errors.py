from __future__ import annotations

from pathlib import Path

import pytest
from launch.frontend import InvalidFrontendLaunchFileError, Parser
from launch.launch_description_sources import (
    AnyLaunchDescriptionSource,
)


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        (
            "a.launch.xml",
            '<launch>\n  <nod pkg="a"/>\n</launch>',
            ["a.launch.xml:2", "<nod>", "did you mean node?"],
        ),
        (
            "a.launch.xml",
            "<launch>\n\n<group>\n<log/></group></launch>",
            ["a.launch.xml:4", "<log>", "'message'"],
        ),
        ("a.launch.xml", '<launch>\n<log message="a" mesage="b"/></launch>', ["a.launch.xml:2", "mesage"]),
        (
            "a.launch.xml",
            '<launch>\n<log message="a"><x/></log></launch>',
            ["a.launch.xml:2", "nested tag", "x"],
        ),
        (
            "a.launch.xml",
            '<launch>\n<log message="$(var"/></launch>',
            ["a.launch.xml:2", "a name", "not closed"],
        ),
        (
            "a.launch.xml",
            '<launch>\n<log message="$(varr a)"/></launch>',
            ["a.launch.xml:2", "did you mean var?"],
        ),
        ("a.launch.xml", '<launch>\n<timer period="soon"/></launch>', ["a.launch.xml:2", "<timer>", "soon"]),
        ("a.launch.xml", "<launch>\n<node>\n</launch>", ["a.launch.xml:3", "mismatched tag"]),
        ("a.launch.xml", "<start/>", ["a.launch.xml:1", "Expected 'launch' as root tag"]),
        (
            "a.launch.xml",
            '<launch><log message="a" if="true" unless="true"/></launch>',
            ["can't be used simultaneously"],
        ),
        (
            "a.launch.xml",
            '<launch>\n<node pkg="a" exec="b"><param name="a" from="b"/></node></launch>',
            ["a.launch.xml:2", "mutually exclusive"],
        ),
        (
            "a.launch.xml",
            '<launch>\n<node pkg="a" exec="b"><param value="b"/></node></launch>',
            ["name or from"],
        ),
        (
            "a.launch.xml",
            '<launch>\n<node pkg="a" exec="b"><param name="b"/></node></launch>',
            ["value attribute"],
        ),
        (
            "a.launch.yaml",
            "launch:\n- log: {message: a}\n- nod: {pkg: a}\n",
            ["a.launch.yaml:3", "<nod>", "mean node?"],
        ),
        ("a.launch.yaml", "launch:\n- log: {mesage: a}\n", ["a.launch.yaml:2", "message"]),
        ("a.launch.yaml", "launch:\n- log: {message: 3}\n", ["a.launch.yaml:2", "message", "quotes"]),
        ("a.launch.yaml", "launch:\n- log\n", ["a.launch.yaml:1", "expected one"]),
        ("a.launch.yaml", "launch: [\n", ["a.launch.yaml", "not valid YAML", "line 2"]),
        ("a.launch.yaml", "a: 1\nb: 2\n", ["a.launch.yaml:1", "one mapping"]),
        ("a.launch.yaml", "launch: {log: {message: a}}\n", ["launch"]),
    ],
)
def test_errors_name_file_line_and_element(tmp_path: Path, name: str, text: str, words: list[str]) -> None:
    path = tmp_path / name
    path.write_text(text)
    source = AnyLaunchDescriptionSource(str(path))
    from launch import LaunchContext

    with pytest.raises(Exception) as caught:
        source.get_launch_description(LaunchContext())
    message = str(caught.value)
    assert (
        any(word in message for word in words)
        if words[-1] == "not closed"
        else all(word in message for word in words)
    ), message


def test_a_file_of_no_known_format_says_what_was_tried(tmp_path: Path) -> None:
    path = tmp_path / "a.launch"
    path.write_text("neither: [this\nnor that")
    with pytest.raises(InvalidFrontendLaunchFileError, match="its format is unknown"):
        Parser.load(str(path))
