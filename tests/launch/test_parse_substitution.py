"""Text with substitutions, as in launch files of XML and YAML."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from launch import LaunchContext
from launch.frontend.parse_substitution import InvalidSubstitution, parse_if_substitutions, parse_substitution
from launch.utilities import perform_substitutions


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", ""),
        ("plain $ text", "plain $ text"),
        ("$(var a)", "1"),
        ("x$(var a)y$(var b)z", "x1y2z"),
        ("$(var nothing default)", "default"),
        ("$(var nothing 'two words')", "two words"),
        ('$(var nothing "$(var a) and $(var b)")', "1 and 2"),
        ("$(var $(var name))", "1"),
        (r"\$(var a)", "$(var a)"),
        (r"$(var nothing 'it\'s')", "it's"),
        ("$(eval '$(var a) + 1')", "2"),
        ("$(not $(equals $(var a) 1))", "false"),
        ("$(if true yes no)", "yes"),
        ("$( var  a )", "1"),
        ("it's", "it's"),
        ("$(any false true)", "true"),
    ],
)
def test_text_with_substitutions_is_parsed(context: LaunchContext, text: str, expected: str) -> None:
    context.launch_configurations.update({"a": "1", "b": "2", "name": "a"})
    assert perform_substitutions(context, parse_substitution(text)) == expected


@pytest.mark.parametrize("text", ["$(var a", "$(", "$()", "$(var 'a)", "$(var $(env A)"])
def test_what_is_not_closed_is_shown_with_a_caret(text: str) -> None:
    with pytest.raises(InvalidSubstitution, match=r"\^"):
        parse_substitution(text)


def test_an_unknown_substitution_names_a_close_one() -> None:
    with pytest.raises(RuntimeError, match=r"Unknown substitution: vra; did you mean var\?"):
        parse_substitution("$(vra a)")


@pytest.mark.parametrize("text", ["$(var)", "$(env)", "$(not)", "$(anon a b)", "$(dirname x)", "$(equals a)"])
def test_a_wrong_number_of_arguments_is_an_error(text: str) -> None:
    with pytest.raises((TypeError, RuntimeError)):
        parse_substitution(text)


def test_values_without_substitutions_stay_what_they_are() -> None:
    assert parse_if_substitutions(3) == 3
    assert parse_if_substitutions("a") == "a"
    assert parse_if_substitutions(["a", "b"]) == ["a", "b"]
    with pytest.raises(ValueError, match="non-uniform"):
        parse_if_substitutions(["a", 1])


@given(st.text(alphabet=st.characters(exclude_characters="\\$", exclude_categories=["Cs"])))
def test_text_without_dollars_and_backslashes_is_kept(text: str) -> None:
    assert perform_substitutions(LaunchContext(), parse_substitution(text)) == text


@given(st.text())
def test_any_text_is_parsed_or_refused_with_a_known_error(text: str) -> None:
    try:
        parse_substitution(text)
    except (InvalidSubstitution, RuntimeError, TypeError, AttributeError, ValueError):
        pass
