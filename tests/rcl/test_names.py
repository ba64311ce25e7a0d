import pytest
from hypothesis import given
from hypothesis import strategies as st

from coursekit.rcl import names


@pytest.mark.parametrize(
    ("short", "full"),
    [
        ("chatter", "/sim/chatter"),
        ("/chatter", "/chatter"),
        ("~", "/sim/turtle"),
        ("~/pose", "/sim/turtle/pose"),
        ("{node}/pose", "/sim/turtle/pose"),
        ("{ns}/pose", "/sim/pose"),
        ("{namespace}/pose", "/sim/pose"),
        ("/{node}", "/turtle"),
        ("a{node}b", "/sim/aturtleb"),
    ],
)
def test_a_short_name_expands_for_its_node(short, full):
    assert names.expand(short, "turtle", "/sim") == full


def test_the_root_namespace_adds_one_slash():
    assert names.expand("chatter", "n", "/") == "/chatter"
    assert names.expand("~/a", "n", "/") == "/n/a"


def test_an_unknown_substitution_is_named():
    with pytest.raises(names.UnknownSubstitution, match=r"unknown substitution: \{bad\}") as caught:
        names.expand("chatter/{bad}", "n", "/")
    assert caught.value.index == 8


@pytest.mark.parametrize(
    ("validate", "text", "reason", "index"),
    [
        (names.validate_topic_name, "", "topic name must not be empty string", 0),
        (names.validate_topic_name, "a/", "topic name must not end with a forward slash", 1),
        (names.validate_topic_name, "a/42", "topic name token must not start with a number", 2),
        (names.validate_topic_name, "a~", "must not have tilde '~' unless it is the first character", 1),
        (names.validate_topic_name, "a{b", "must not have unmatched (unbalanced) curly braces '{}'", 1),
        (names.validate_topic_name, "{1}", "substitution name must not start with a number", 1),
        (names.validate_topic_name, "{a b}", "substitution name must not contain characters other", 2),
        (names.validate_topic_name, "chatter?", "must not contain characters other than alphanumerics", 7),
        (names.validate_full_topic_name, "a", "topic name must be absolute, it must lead with a '/'", 0),
        (names.validate_full_topic_name, "/a//b", "topic name must not contain repeated '/'", 3),
        (names.validate_full_topic_name, "/" + "a" * 247, "topic length should not exceed", 246),
        (names.validate_namespace, "a", "namespace must be absolute, it must lead with a '/'", 0),
        (names.validate_namespace, "/a/", "namespace must not end with a '/', unless only a '/'", 2),
        (names.validate_namespace, "/1", "must not have a token that starts with a number", 1),
        (names.validate_node_name, "", "node name must not be empty", 0),
        (names.validate_node_name, "a b", "node name must not contain characters other", 1),
        (names.validate_node_name, "1a", "node name must not start with a number", 0),
        (names.validate_node_name, "a" * 256, "node name length should not exceed '255'", 254),
    ],
)
def test_a_bad_name_is_refused_with_reason_and_place(validate, text, reason, index):
    problem = validate(text)
    assert problem is not None
    assert reason in problem[0]
    assert problem[1] == index


@given(st.text(alphabet="abz_/~{}019 ?", max_size=12))
def test_every_name_either_expands_to_a_valid_path_or_is_refused(text):
    try:
        full = names.expand(text, "n", "/ns")
    except names.InvalidName as error:
        assert 0 <= error.index <= len(text)
    else:
        assert full.startswith("/")
        assert names.validate_full_topic_name(full) is None or "//" in full or names.expand(full, "n", "/ns")


def test_hidden_names_have_a_token_with_an_underscore():
    assert names.is_hidden("/a/_action/status")
    assert names.is_hidden("_hidden")
    assert not names.is_hidden("/a_b/c_")


def test_the_join_of_the_root_and_a_name_has_one_slash():
    assert names.join("/", "n") == "/n"
    assert names.join("/ns", "n") == "/ns/n"
