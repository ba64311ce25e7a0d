import pytest
from rclpy.exceptions import (
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidServiceNameException,
    InvalidTopicNameException,
)
from rclpy.expand_topic_name import expand_topic_name
from rclpy.topic_or_service_is_hidden import topic_or_service_is_hidden
from rclpy.validate_full_topic_name import validate_full_topic_name
from rclpy.validate_namespace import validate_namespace
from rclpy.validate_node_name import validate_node_name
from rclpy.validate_topic_name import TOPIC_SEPARATOR_STRING, validate_topic_name


@pytest.mark.parametrize(
    "name", ["chatter", "/chatter", "a/b", "~/a", "~", "{node}/a", "a{ns}", "_a", "a_1", "a//b"]
)
def test_topic_names(name):
    assert validate_topic_name(name)


@pytest.mark.parametrize(
    ("name", "reason", "index"),
    [
        ("", "topic name must not be empty string", 0),
        ("a b", "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'", 1),
        ("a/", "topic name must not end with a forward slash", 1),
        ("1a", "topic name token must not start with a number", 0),
        ("a/1b", "topic name token must not start with a number", 2),
        ("a~", "topic name must not have tilde '~' unless it is the first character", 1),
        ("~abc", "topic name must not have a tilde '~' that is not followed by a forward slash '/'", 1),
        ("a{b", "topic name must not have unmatched (unbalanced) curly braces '{}'", 1),
        ("{1a}", "substitution name must not start with a number", 1),
        ("{a b}", "substitution name must not contain characters other than alphanumerics or '_'", 2),
    ],
)
def test_bad_topic_names(name, reason, index):
    with pytest.raises(InvalidTopicNameException) as caught:
        validate_topic_name(name)
    first, second, third = str(caught.value).split("\n")
    assert first == f"Invalid topic name: {reason}:"
    assert second == f"  '{name}'"
    assert third == " " * (3 + index) + "^"
    with pytest.raises(InvalidServiceNameException, match="Invalid service name"):
        validate_topic_name(name, is_service=True)


@pytest.mark.parametrize("name", ["/chatter", "/a/b", "/_a"])
def test_full_topic_names(name):
    assert validate_full_topic_name(name)


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("", "topic name must not be empty"),
        ("a", "topic name must be absolute, it must lead with a '/'"),
        ("/a/", "topic name must not end with a '/'"),
        ("/a//b", "topic name must not contain repeated '/'"),
        ("/1", "topic name must not have a token that starts with a number"),
        ("/{a}", "topic name must not contain characters other than alphanumerics, '_', or '/'"),
        ("/" + "a" * 247, "topic length should not exceed"),
    ],
)
def test_bad_full_topic_names(name, reason):
    with pytest.raises(InvalidTopicNameException) as caught:
        validate_full_topic_name(name)
    assert reason in str(caught.value)


@pytest.mark.parametrize("namespace", ["/", "/a", "/a/b"])
def test_namespaces(namespace):
    assert validate_namespace(namespace)


@pytest.mark.parametrize("namespace", ["", "a", "/a/", "/a//b", "/1", "/a b", "/" + "a" * 245])
def test_bad_namespaces(namespace):
    with pytest.raises(InvalidNamespaceException):
        validate_namespace(namespace)


@pytest.mark.parametrize("name", ["a", "_a", "a1", "a" * 255])
def test_node_names(name):
    assert validate_node_name(name)


@pytest.mark.parametrize("name", ["", "1a", "a/b", "a b", "a" * 256])
def test_bad_node_names(name):
    with pytest.raises(InvalidNodeNameException):
        validate_node_name(name)


@pytest.mark.parametrize(
    ("name", "full"),
    [
        ("chatter", "/ns/chatter"),
        ("/chatter", "/chatter"),
        ("~", "/ns/n"),
        ("~/a", "/ns/n/a"),
        ("{node}/a", "/ns/n/a"),
        ("/{node}", "/n"),
        ("{ns}/a", "/ns/a"),
        ("{namespace}/a", "/ns/a"),
    ],
)
def test_expansion(name, full):
    assert expand_topic_name(name, "n", "/ns") == full


@pytest.mark.parametrize(
    "arguments", [("a b", "n", "/"), ("a", "1", "/"), ("a", "n", "x"), ("{bad}", "n", "/")]
)
def test_what_cannot_be_expanded(arguments):
    with pytest.raises(ValueError, match="is invalid"):
        expand_topic_name(*arguments)


@pytest.mark.parametrize(
    ("name", "hidden"), [("/a", False), ("/_a", True), ("/a/_b", True), ("_a", True), ("/a/b_", False)]
)
def test_hidden_names(name, hidden):
    assert topic_or_service_is_hidden(name) is hidden


def test_a_topic_is_taken_apart_at_its_separator():
    assert "/arm/camera/image".split(TOPIC_SEPARATOR_STRING)[-1] == "image"
