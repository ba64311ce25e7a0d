"""Tools of launch tests: programs that a test starts, assertions on output, filters, nodes beside a test."""

from __future__ import annotations

import re
import time
import unittest
from functools import partial

import launch_testing
import pytest
import rclpy
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node
from launch_testing.actions import ReadyToTest
from launch_testing.asserts import NO_CMD_ARGS, assertInStderr, assertInStdout, assertSequentialStdout
from launch_testing.junitxml import unittestResultsToXml
from launch_testing.tools import basic_output_filter, expect_output, expected_output_from_file, launch_process
from launch_testing_ros import DataRepublisher, MessagePump, WaitForTopics
from launch_testing_ros.tools import basic_output_filter as ros_output_filter
from std_msgs.msg import String

from tests.needs import posix


def talker() -> Node:
    return Node(package="demo_nodes_py", executable="talker", name="t")


def check(results, *classes, entities=()) -> None:
    result_by_run = results(lambda: LaunchDescription([talker(), *entities, ReadyToTest()]), *classes)
    failed = [text for result in result_by_run.values() for _, text in (*result.failures, *result.errors)]
    assert not failed and all(result.testsRun for result in result_by_run.values()), "\n".join(failed)


def test_a_test_starts_commands_and_waits_for_what_they_print(results) -> None:
    class Beside(unittest.TestCase):
        def start(self, launch_service, proc_info, proc_output, *words):
            action = ExecuteProcess(cmd=["ros2", *words], name="cli")
            return launch_process(launch_service, action, proc_info, proc_output)

        def test_end(self, launch_service, proc_info, proc_output):
            with self.start(launch_service, proc_info, proc_output, "node", "list") as command:
                assert not command.running and not command.terminated
                assert command.wait_for_shutdown(timeout=10)
            assert command.exit_code == 0 and not command.running
            assert expect_output(expected_lines=["/t"], text=command.output, strict=True), command.output

        def test_output(self, launch_service, proc_info, proc_output):
            with self.start(launch_service, proc_info, proc_output, "topic", "echo", "/chatter") as command:
                lines = [re.compile(r"data: 'Hello World: \d+'"), "---"]
                matched = command.wait_for_output(partial(expect_output, expected_lines=lines), timeout=10)
                assert matched, matched
                assert command.running and command.stderr == "" and command.stdout == command.output
                in_vain = command.wait_for_output(lambda text: "never" in text, timeout=1)
                assert not in_vain and repr(in_vain).startswith("<BoolWithText(False): \"data: 'Hello")
            assert command.wait_for_shutdown(timeout=10)

        def test_short(self, launch_service, proc_info, proc_output):
            with self.start(launch_service, proc_info, proc_output, "topic", "info", "/none") as command:
                assert command.wait_for_output(lambda text: "Unknown topic '/none'" in text, timeout=2)
            with self.assertRaisesRegex(TypeError, "Expected 'condition' to be callable"):
                command.wait_for_output("text")

    check(results, Beside)


@posix("there is no sh")
def test_output_is_looked_for_by_process_stream_and_order(results) -> None:
    program = "echo one; echo two >&2; echo three; echo \033[31mred\033[0m"

    class Beside(unittest.TestCase):
        def test_wait(self, proc_output):
            proc_output.assertWaitFor("red", process="sh", stream="stdout")
            assert not proc_output.waitFor("none", timeout=0.5)
            with self.assertRaisesRegex(Exception, "Did not find any processes matching name 'cat'"):
                proc_output.assertWaitFor("none", process="cat", timeout=0.5)

    @launch_testing.post_shutdown_test()
    class After(unittest.TestCase):
        def test_streams(self, proc_output):
            assertInStdout(proc_output, ["one", "three", re.compile("^red$", re.MULTILINE)], "sh")
            assertInStderr(proc_output, "two", process="sh", cmd_args=["-c"])
            for wrong, kind in (
                ({"process": "sh", "cmd_args": NO_CMD_ARGS}, "any processes"),
                ({"process": 3}, "argument must be"),
            ):
                with self.assertRaisesRegex(Exception, kind):
                    assertInStdout(proc_output, "one", **wrong)
            with self.assertRaisesRegex(ValueError, "must be 'stdout' or 'stderr'"):
                launch_testing.asserts.assertInStream(proc_output, "one", "sh", stream="out")

        def test_order(self, proc_output):
            with assertSequentialStdout(proc_output, "sh") as checker:
                checker.assertInStdout("one")
                checker.assertInStdout("three")
                with self.assertRaisesRegex(AssertionError, "'one' not found in sequence after previous match"):
                    checker.assertInStdout("one")

        def test_names(self, proc_output):
            with self.assertRaisesRegex(Exception, "Found multiple processes matching name ''"):
                assertInStdout(proc_output, "one", "")
            assertInStdout(proc_output, "one", "", strict_proc_matching=False)

    check(results, Beside, After, entities=[ExecuteProcess(cmd=["sh", "-c", program])])


def test_filters_leave_out_lines_by_how_they_begin_and_what_they_match(tmp_path, monkeypatch) -> None:
    assert basic_output_filter()("pid 1\nrc 0\nkept\n") == "kept\n"
    for kind, line in (("prefixes", "noise"), ("patterns", ".*loud.*")):
        folder = tmp_path / "share" / "ament_index" / "resource_index" / f"rmw_output_{kind}"
        folder.mkdir(parents=True)
        (folder / "rmw_loud").write_text(line + "\n")
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    text = "noise\nvery loud\nkept\npid 1\n"
    assert ros_output_filter(filtered_rmw_implementation="rmw_loud")(text) == "kept\n"
    assert ros_output_filter(filtered_prefixes=[], filtered_rmw_implementation="rmw_quiet")(text) == text
    with pytest.raises(TypeError, match='Unsupported filter_type "lines"'):
        launch_testing_ros_filter("rmw_loud", "lines")


def launch_testing_ros_filter(*args: str) -> list[str]:
    from launch_testing_ros.tools import get_rmw_output_filter

    return get_rmw_output_filter(*args)


def test_expected_output_is_read_from_files(tmp_path) -> None:
    (tmp_path / "a.txt").write_text("one\ntwo\n")
    (tmp_path / "b.regex").write_text("o.e\n")
    assert expected_output_from_file(str(tmp_path / "a")) == ["one", "two"]
    assert expect_output("one\n", expected_lines=expected_output_from_file(str(tmp_path / "b")))
    with pytest.raises(RuntimeError, match="could not find output check file"):
        expected_output_from_file(str(tmp_path / "c"))


@pytest.mark.parametrize("given", [{}, {"text": "a", "lines": ["a"]}])
def test_either_text_or_lines_are_compared(given: dict) -> None:
    with pytest.raises(ValueError, match="Either lines or text"):
        expect_output(**given, expected_text="a")
    with pytest.raises(ValueError, match="Either expected lines or text"):
        expect_output(text="a")
    for matched in ({"expected_text": 3}, {"expected_lines": []}):
        with pytest.raises(ValueError):
            expect_output(text="a", **matched)


def test_tests_wait_for_topics(results, session) -> None:
    class Beside(unittest.TestCase):
        def test_comes(self):
            with WaitForTopics([("chatter", String)], timeout=5.0) as waiting:
                assert waiting.topics_received() == {"chatter"}
                assert waiting.received_messages("chatter")[0].data.startswith("Hello World: ")
                with self.assertRaisesRegex(KeyError, "'silence' is not one of the topics .*chatter"):
                    waiting.received_messages("silence")

        def test_the_last_messages_are_kept(self):
            with WaitForTopics([("chatter", String)], timeout=5.0, messages_received_buffer_length=2) as waiting:
                time.sleep(4)
                kept = [message.data for message in waiting.received_messages("chatter")]
            number = int(kept[-1].split()[-1])
            assert number > 2 and kept == [f"Hello World: {number - 1}", f"Hello World: {number}"]

        def test_is_missing(self):
            topics = [("chatter", String), ("silence", String)]
            with self.assertRaisesRegex(RuntimeError, "Did not receive messages on these topics"):
                WaitForTopics(topics, timeout=3.0).__enter__()
            waiting = WaitForTopics([("silence", String)], timeout=1.0)
            assert not waiting.wait() and waiting.topics_not_received() == {"silence"}
            waiting.shutdown()

    check(results, Beside)


def test_messages_are_passed_on_beside_a_test(results) -> None:
    class Beside(unittest.TestCase):
        def test_republish(self, proc_output):
            rclpy.init()
            node = rclpy.create_node("between")
            heard = []
            node.create_subscription(String, "louder", lambda message: heard.append(message.data), 10)

            def transform(message):
                return None if message.data.endswith("1") else String(data=message.data.upper())

            between = DataRepublisher(node, "chatter", "louder", String, transform)
            pump = MessagePump(node)
            pump.start()
            proc_output.assertWaitFor("Hello World: 2")
            proc_output.assertWaitFor("Hello World: 3")
            pump.stop()
            between.shutdown()
            rclpy.shutdown()
            assert heard[:2] == ["HELLO WORLD: 0", "HELLO WORLD: 2"]
            assert between.get_num_received() == between.get_num_republished() + 1 >= 3
            assert between.get_republished()[0].data == "Hello World: 0"

    check(results, Beside)


def test_reports_name_a_test_by_its_module_and_class_wherever_the_class_stands(results) -> None:
    class Beside(unittest.TestCase):
        def test_it(self) -> None:
            pass

    report = unittestResultsToXml(test_results=results(lambda: LaunchDescription([talker(), ReadyToTest()]), Beside))
    (case,) = report.getroot().iter("testcase")
    assert (case.get("classname"), case.get("name")) == (f"{__name__}.Beside", "test_it")
