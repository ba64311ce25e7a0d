import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from coursekit.rcl import parameter_file
from coursekit.rcl.parameter_file import ParameterFileError, parse, parse_value, values_for

MARK = "ros__parameters"


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("yes", True), ("off", False), ("tRue", "tRue"), ("y", True), ("1", 1), ("0x1F", 31), ("017", 15),
        ("08", 8.0), ("0o17", "0o17"), ("1_000", "1_000"), ("1.0e3", 1000.0), ("1e3", 1000.0), (".5", 0.5),
        ("-.inf", -math.inf), ("infinity", math.inf), ("'true'", "true"), ('"1"', "1"), ("~", "~"),
        ("null", "null"), ("[1, 0x10]", [1, 16]), ("[yes, no]", [True, False]), ('["1", "2"]', ["1", "2"]),
        ("[1.5, .inf]", [1.5, math.inf]), ("[]", None), ("1.0.0", "1.0.0"), ("2020-01-01", "2020-01-01"),
        ("9223372036854775808", 9223372036854775808.0), ("!!str 1", "1"), ("1e400", "1e400"), ("''", ""),
    ],
)  # fmt: skip
def test_a_value_has_the_type_that_rcl_gives(text, value):
    parsed = parse_value(text)
    assert parsed == value
    assert type(parsed) is type(value)


def test_not_a_number_is_read():
    assert math.isnan(parse_value(".nan"))


@pytest.mark.parametrize("text", ["[1, 2.5]", "[2.5, 1]", "[1, true]", '["1", 2]'])
def test_a_list_holds_one_type(text):
    with pytest.raises(ParameterFileError, match="Sequence should be of same type"):
        parse_value(text)


@given(st.one_of(st.integers(-(2**63), 2**63 - 1), st.floats(allow_nan=False), st.booleans()))
def test_written_numbers_come_back(value):
    assert parse_value(repr(value)) == value
    assert type(parse_value(repr(value))) is type(value)


@pytest.mark.parametrize(
    ("pattern", "node", "covers"),
    [
        ("/**", "/s/n", True), ("/*", "/s/n", False), ("/*", "/n", True), ("/*/n", "/s/n", True),
        ("/*/n", "/n", False), ("/**/n", "/n", True), ("/**/n", "/a/b/n", True), ("/s/*", "/s/n", True),
        ("/s/**", "/s/t/n", True), ("/s/n", "/s/n", True), ("/**/t/**/n", "/s/t/n", True), 
        ("/n", "/s/n", False),
    ],
)  # fmt: skip
def test_a_wildcard_covers_one_name_or_any_number(pattern, node, covers):
    assert parameter_file.matches(pattern, node) is covers


@pytest.mark.parametrize(
    "key", ["/s/n", "s/n", "s:\n  n", "/s:\n  n", "/**", '"**"', "/*/*", '/**:\n  "*"', "/*/n"]
)
def test_a_node_is_named_by_path_nesting_or_wildcard(key):
    depth = "  " * (key.count("\n") + 1)
    overrides = parse(f"{key}:\n{depth}{MARK}:\n{depth}  a: 1\n")
    assert values_for(overrides, "/s/n") == {"a": 1}


def test_nested_names_join_with_dots():
    text = f"/**:\n  {MARK}:\n    a:\n      b: {{c: 1}}\n      d: [1, 2]\n    a.e: x\n"
    assert values_for(parse(text), "/n") == {"a.b.c": 1, "a.d": [1, 2], "a.e": "x"}


def test_repeated_keys_accumulate_where_they_stood_first():
    text = "".join(
        f"{node}:\n  {MARK}:\n    {values}\n"
        for node, values in [("/**", "a: 1"), ("/s/n", "{a: 2, b: 2}"), ("/**", "{a: 5, d: 4}")]
    )
    assert values_for(parse(text), "/s/n") == {"a": 2, "b": 2, "d": 4}
    assert values_for(parse(text), "/other") == {"a": 5, "d": 4}


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("n:\n  a: 1\n", "Cannot have a value before ros__parameters at line 2"),
        (f"n:\n  {MARK}: 1\n", "Cannot have a value before ros__parameters at line 2"),
        (f"{MARK}:\n  a: 1\n", "There are no node names before ros__parameters at line 1"),
        ("- a\n", "Sequences cannot be key at line 1"),
        (f"n:\n  {MARK}:\n    a:\n", "No value at line 3"),
        (f"n:\n  {MARK}:\n    a: &x 1\n    b: *x\n", "Will not support aliasing at line 4"),
        ("n:\n\ta: 1\n", "Error parsing a event near line 2"),
        (f"n*:\n  {MARK}:\n    a: 1\n", "node name must not contain characters other than alph"),
        (f"/s/n/:\n  {MARK}:\n    a: 1\n", "node name must not be empty"),
        (f"n:\n  {MARK}:\n    a: [{{b: 1}}]\n", "Unknown YAML event"),
    ],
)
def test_a_bad_file_is_refused_with_reason_and_line(text, reason):
    with pytest.raises(ParameterFileError) as caught:
        parse(text)
    assert reason in str(caught.value)


def test_a_file_that_is_not_there_is_named(tmp_path):
    with pytest.raises(ParameterFileError, match=r"Error opening YAML file: .*nope"):
        parameter_file.read(tmp_path / "nope.yaml")


@pytest.mark.parametrize("text", ["", "# only a comment\n"])
def test_an_empty_file_says_nothing(text):
    assert parse(text) == {}
