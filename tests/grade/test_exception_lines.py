"""The line that is told with an exception: the student's own, never one of the course's or of a message's class."""

import os
from pathlib import Path

import pytest

from coursekit.grade import chapters
from coursekit.grade.outputs import exception_in
from coursekit.grade.plain import called
from coursekit.grade.stopped_function import error_of
from coursekit.grade.verdict import Wrong


def test_an_error_without_words_is_its_name():
    assert error_of(AssertionError()) == "AssertionError"


def test_a_line_of_the_course_s_own_code_is_never_shown():
    from rclpy import executors

    inside = f'  File "{executors.__file__}", line 28, in _take\n    result = callback(*args)\n'
    died = f"Traceback (most recent call last):\n{inside}TypeError: work() missing 1 required positional argument: 'x'\n"
    assert exception_in(died) == "TypeError: work() missing 1 required positional argument: 'x'"


def test_a_student_s_folder_beside_the_course_s_code_is_the_student_s():
    beside = f"{Path(chapters.__file__).parents[2]}_ws{os.sep}ear.py"
    frame = f'  File "{beside}", line 3, in heard\n    self.count += one\n'
    died = f"Traceback (most recent call last):\n{frame}NameError: one\n"
    assert exception_in(died) == "NameError: one (line 3 of ear.py: self.count += one)"
    scope = {}
    exec(compile("def tip(a):\n    return [a][1]\n", beside, "exec"), scope)
    with pytest.raises(Wrong) as caught:
        called(scope["tip"], 1.0, told="tip(1.0)")
    assert caught.value.got == "IndexError: list index out of range (line 2)"


def test_a_function_s_own_line_is_shown():
    scope = {}
    exec(compile("def tip(a):\n    return [a][1]\n", "<cell>", "exec"), scope)
    with pytest.raises(Wrong) as caught:
        called(scope["tip"], 1.0, told="tip(1.0)")
    assert caught.value.got == "IndexError: list index out of range (line 2)"
    assert error_of(ValueError("x")) == "ValueError: x"


def test_the_line_in_the_class_of_a_message_is_not_taken_for_the_student_s():
    from std_msgs.msg import Bool

    def switch():
        return Bool(data="yes")

    with pytest.raises(AssertionError) as caught:
        switch()
    assert error_of(caught.value).endswith('return Bool(data="yes"))')
