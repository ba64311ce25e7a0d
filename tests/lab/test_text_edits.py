"""Edits of the chapters can be made again in any order, and each stands there once."""

from itertools import permutations

import pytest

from coursekit.lab.text_edits import appended, edited

SETUP = "setup(\n    entry_points={\n        'console_scripts': [\n        ],\n    },\n)\n"
SCRIPTS = "'console_scripts': ["
NODES = [
    (SCRIPTS, f"{SCRIPTS}\n            'publisher_exe = pkg.publisher:main',"),
    ("'publisher_exe", "'subscriber_exe = pkg.subscriber:main',\n            'publisher_exe"),
    ("'publisher_exe", "'relay_exe = pkg.relay:main',\n            'publisher_exe"),
]
CMAKE = "find_package(ament_cmake REQUIRED)\nament_package()\n"
INTERFACES = [
    (
        "find_package(ament_cmake REQUIRED)\n",
        "find_package(ament_cmake REQUIRED)\nfind_package(rosidl REQUIRED)\nrosidl_generate_interfaces(\n"
        '  "msg/One.msg"\n  DEPENDENCIES builtin_interfaces\n)\n',
    ),
    ('  "msg/One.msg"\n', '  "srv/Two.srv"\n  "msg/One.msg"\n'),
    ("DEPENDENCIES builtin_interfaces\n", "DEPENDENCIES builtin_interfaces geometry_msgs\n"),
    ("builtin_interfaces geometry_msgs\n", "builtin_interfaces geometry_msgs action_msgs\n"),
]


@pytest.mark.parametrize(("text", "edits"), [(SETUP, NODES), (CMAKE, INTERFACES)])
def test_after_all_edits_each_can_be_made_again_in_any_order_and_changes_nothing(text, edits):
    for old, new in edits:
        text = edited(text, old, new)
    for order in permutations(edits):
        for old, new in order:
            assert edited(text, old, new) == text, (old, new)
    assert text.count("publisher_exe =") <= 1 and text.count("find_package(rosidl") <= 1


def test_what_a_student_typed_by_hand_is_not_added_again():
    typed = SETUP.replace(SCRIPTS, f"{SCRIPTS}\n  'other = a:b',\n  'publisher_exe = pkg.publisher:main',")
    assert edited(typed, *NODES[0]) == typed


def test_the_same_line_on_the_other_side_is_another_one():
    text = "    <depend>a</depend>\n  <exec>b</exec>\n"
    want = text + "    <depend>a</depend>\n"
    assert edited(text, "  <exec>b</exec>\n", "  <exec>b</exec>\n    <depend>a</depend>\n") == want


def test_a_break_that_was_mended_can_be_made_again():
    broken = edited("lookup(Time())", "Time()", "now()")
    mended = edited(broken, "now()", "Time()")
    assert (mended, edited(mended, "Time()", "now()")) == ("lookup(Time())", broken)


def test_what_is_not_there_cannot_be_edited():
    assert edited("a\n", "b", "c") is None


@pytest.mark.parametrize(
    ("text", "piece", "former", "whole"),
    [
        ("a\n", "b\n", None, "a\nb\n"),
        ("a\nb\n", "b\n", None, "a\nb\n"),
        ("a\nb\nc\n", "b\n", "b\n", "a\nb\nc\n"),
        ("a\nb\nc\n", "B\n", "b\n", "a\nB\nc\n"),
        ("a\n", "B\n", "b\n", "a\nB\n"),
    ],
)
def test_a_piece_stands_once_where_it_stood(text, piece, former, whole):
    assert appended(text, piece, former) == whole
