"""What tests of rosidl_runtime_py and of the ament index ask for: fixtures, plain values, serialized messages, a command."""

from __future__ import annotations

import copy
import warnings
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
import test_msgs.srv
from ament_index_python.cli import main, resource_name_completer, resource_type_completer
from rosidl_parser.definition import NamespacedType, UnboundedSequence
from rosidl_runtime_py import (
    get_interfaces,
    message_to_csv,
    message_to_ordereddict,
    message_to_yaml,
    set_message_fields,
)
from rosidl_runtime_py.convert import _convert_value
from rosidl_runtime_py.import_message import import_message_from_namespaced_type
from test_msgs import message_fixtures
from test_msgs.msg import Empty
from test_msgs.service_fixtures import get_test_srv

from coursekit.interfaces import cdr

FIXTURES = sorted(name for name in vars(message_fixtures) if name.startswith("get_msg_"))


@pytest.mark.parametrize("name", FIXTURES)
def test_fixtures_can_be_shown_filled_and_sent(name: str) -> None:
    for message in getattr(message_fixtures, name)():
        kept = copy.deepcopy(message)
        assert set_message_fields(message, {}) == [] and message == kept
        assert cdr.deserialize(cdr.serialize(message), type(message)) == message
        for limit in (None, 1):
            assert isinstance(message_to_csv(message, truncate_length=limit), str)
            assert isinstance(message_to_yaml(message, truncate_length=limit), str)


def test_fixtures_differ_from_each_other() -> None:
    for name in ("basic_types", "strings", "nested", "unbounded_sequences", "bounded_sequences"):
        messages = getattr(message_fixtures, f"get_msg_{name}")()
        assert len({str(message) for message in messages}) == len(messages) > 1


@pytest.mark.parametrize("name", ["Empty", "BasicTypes", "Arrays"])
def test_requests_and_responses_for_tests_can_be_sent_and_told_apart(name: str) -> None:
    pairs = get_test_srv(name)
    for message in [part for pair in pairs for part in pair]:
        assert cdr.deserialize(cdr.serialize(message), type(message)) == message
    kind = getattr(test_msgs.srv, name)
    assert all(isinstance(request, kind.Request) and isinstance(reply, kind.Response) for request, reply in pairs)
    assert len({str(request) for request, _ in pairs}) == len({str(reply) for _, reply in pairs}) == len(pairs)


def test_a_service_without_fixtures_is_refused() -> None:
    with pytest.raises(NotImplementedError, match="'Nothing'"):
        get_test_srv("Nothing")


@pytest.mark.parametrize(
    ("value", "limit", "plain"),
    [
        (True, 0, True),
        ((1, 2, 3), 0, ("...",)),
        (["123", "456"], 1, ["1...", "..."]),
        (b"hello world", 5, "hello..."),
        ({1: "abc", "234": "bcd"}, 1, {1: "a...", "234": "b..."}),
    ],
)
def test_values_become_plain(value: Any, limit: int, plain: Any) -> None:
    assert _convert_value(value, truncate_length=limit) == plain


def test_a_serialized_message_is_shown_as_its_bytes() -> None:
    data = b"\xce\xbb"
    assert message_to_ordereddict(data) == {"bytes": data}
    assert "zrs=" in message_to_yaml(data) and message_to_csv(data) == str(data)


def test_the_items_of_a_sequence_are_still_imported_with_a_warning() -> None:
    items = NamespacedType(["test_msgs", "msg"], "Empty")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert import_message_from_namespaced_type(items) is Empty
    with pytest.warns(DeprecationWarning, match="type of the items"):
        assert import_message_from_namespaced_type(UnboundedSequence(items)) is Empty


def test_a_package_without_interfaces_is_left_out() -> None:
    assert list(get_interfaces(["test_msgs", "rosidl_parser"])) == ["test_msgs"]


def test_the_index_is_queried_by_type_and_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Any) -> None:
    index = tmp_path / "share/ament_index/resource_index"
    for kind, text in (("colours", "red"), ("shapes", "")):
        (index / kind).mkdir(parents=True)
        (index / kind / "foo").write_text(text)
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    for words, shown in (
        (["colours"], f"foo\t{tmp_path}\n"),
        (["colours", "foo"], f"{tmp_path}\n<<<\nred\n>>>\n"),
        (["shapes", "foo"], f"{tmp_path}\n"),
    ):
        assert main(words) is None and capsys.readouterr().out == shown
    main()
    assert capsys.readouterr().out == "colours\nshapes\n"
    assert main(["colours", "bar"]) == "Could not find the resource 'bar' of type 'colours'"
    assert resource_type_completer("col") == ["colours"]
    assert resource_name_completer("f", SimpleNamespace(resource_type="colours")) == ["foo"]
    assert resource_name_completer("f", SimpleNamespace(resource_type=None)) == []


def test_a_message_type_keeps_its_namespaces_as_a_list() -> None:
    kind = NamespacedType(("test_msgs", "msg"), "Empty")
    assert kind.namespaces == ["test_msgs", "msg"] and kind.namespaced_name() == ("test_msgs", "msg", "Empty")
    assert {kind: 1}[NamespacedType(["test_msgs", "msg"], "Empty")] == 1


def test_a_class_of_a_program_with_slots_is_filled_and_shown_like_a_message() -> None:
    from builtin_interfaces.msg import Time
    from rosidl_parser.definition import NamespacedType
    from rosidl_runtime_py import message_to_ordereddict, set_message_fields

    class Stamped:
        __slots__ = ("_stamp",)
        SLOT_TYPES = (NamespacedType(["builtin_interfaces", "msg"], "Time"),)

        def __init__(self) -> None:
            self._stamp = Time()

        @property
        def stamp(self) -> Time:
            return self._stamp

        @stamp.setter
        def stamp(self, value: Time) -> None:
            self._stamp = value

    msg = Stamped()
    set_message_fields(msg, {"stamp": {"sec": 2}})
    assert msg.stamp.sec == 2
    for setter in set_message_fields(msg, {"stamp": "now"}, expand_time_now=True):
        setter(Time(sec=3))
    assert message_to_ordereddict(msg)["stamp"]["sec"] == 3
