import re

import pytest
import rclpy.logging
from rcl_interfaces.msg import Log
from rclpy.clock import Clock, ClockType
from rclpy.impl.rcutils_logger import RcutilsLogger
from rclpy.logging import LoggingSeverity, get_logger, get_logging_severity_from_string
from rclpy.time import Time
from std_msgs.msg import String
from std_srvs.srv import Empty

LINE = re.compile(r"\[(\w+)\] \[\d+\.\d{9}\] \[([^\]]*)\]: (.*)")


@pytest.fixture
def logger(request):
    logger = get_logger(f"t_{abs(hash(request.node.nodeid))}")
    yield logger
    logger.set_level(LoggingSeverity.UNSET)


def test_a_line_has_severity_stamp_name_and_text(logger, capfd):
    assert logger.info("hello")
    severity, name, text = LINE.search(capfd.readouterr().err).groups()
    assert (severity, name, text) == ("INFO", logger.name, "hello")


@pytest.mark.parametrize("message", [5, True, ValueError("e"), String(), ["a"]])
def test_what_is_no_text_is_refused_when_it_would_be_shown(logger, message):
    with pytest.raises(TypeError, match=r"rclpy_logging_rcutils_log\(\): incompatible function arguments"):
        logger.info(message)
    assert not logger.debug(message)


@pytest.mark.parametrize(("message", "text"), [(b"ab", "ab"), (None, "(null)")])
def test_bytes_and_nothing_are_shown(logger, message, text, capfd):
    assert logger.info(message)
    assert LINE.search(capfd.readouterr().err)[3] == text


@pytest.mark.parametrize("severity", ["info", "warning", "error", "fatal"])
def test_severities_are_shown_by_default(logger, severity, capfd):
    assert getattr(logger, severity)("text")
    assert LINE.search(capfd.readouterr().err)[1] == severity.upper().replace("WARNING", "WARN")


def test_debug_is_not_shown_by_default(logger, capfd):
    assert not logger.debug("text")
    assert capfd.readouterr().err == ""


def test_a_level_hides_what_is_below(logger):
    logger.set_level(LoggingSeverity.ERROR)
    assert not logger.warning("text")
    assert logger.error("text")
    assert logger.is_enabled_for(LoggingSeverity.FATAL)
    assert not logger.is_enabled_for(LoggingSeverity.WARN)
    assert logger.get_effective_level() == LoggingSeverity.ERROR


def test_a_level_goes_down_the_names(logger):
    child = logger.get_child("child")
    assert child.name == f"{logger.name}.child"
    logger.set_level(LoggingSeverity.FATAL)
    assert child.get_effective_level() == LoggingSeverity.FATAL
    child.set_level(LoggingSeverity.DEBUG)
    assert child.get_effective_level() == LoggingSeverity.DEBUG
    assert logger.get_effective_level() == LoggingSeverity.FATAL
    child.set_level(LoggingSeverity.UNSET)
    assert child.get_effective_level() == LoggingSeverity.FATAL


def test_levels_are_set_by_name(logger):
    rclpy.logging.set_logger_level(logger.name, LoggingSeverity.WARN)
    assert rclpy.logging.get_logger_effective_level(logger.name) == LoggingSeverity.WARN


@pytest.mark.parametrize("level", [15, "INFO", None, -1])
def test_what_is_no_level_is_refused(logger, level):
    with pytest.raises(ValueError):
        logger.set_level(level)


@pytest.mark.parametrize("name", ["", None])
def test_a_logger_has_a_name(logger, name):
    with pytest.raises(ValueError):
        get_logger(name)
    with pytest.raises(ValueError):
        logger.get_child(name)


@pytest.mark.parametrize("severity", list(LoggingSeverity)[1:])
def test_log_takes_a_severity(logger, severity):
    logger.set_level(LoggingSeverity.DEBUG)
    assert logger.log("text", severity)


def test_severities_have_words():
    assert get_logging_severity_from_string("warn") == LoggingSeverity.WARN
    assert get_logging_severity_from_string("FATAL") == LoggingSeverity.FATAL
    with pytest.raises(RuntimeError):
        get_logging_severity_from_string("loud")


def test_once(logger):
    assert [logger.info("text", once=True) for _ in range(3)] == [True, False, False]


def test_skip_first(logger):
    assert [logger.info("text", skip_first=True) for _ in range(3)] == [False, True, True]


def test_skip_first_then_once(logger):
    assert [logger.info("text", skip_first=True, once=True) for _ in range(4)] == [False, True, False, False]


def test_throttle(logger):
    assert [logger.info("text", throttle_duration_sec=100) for _ in range(3)] == [True, False, False]


def test_throttle_by_ros_time(logger):
    clock = Clock(clock_type=ClockType.ROS_TIME)
    clock._set_ros_time_is_active(True)
    shown = []
    for second in (10, 10.5, 11.5, 12, 13):
        clock.set_ros_time_override(Time(seconds=second, clock_type=ClockType.ROS_TIME))
        shown.append(logger.info("text", throttle_duration_sec=1, throttle_time_source_type=clock))
    assert shown == [True, False, True, False, True]


def test_each_line_of_code_has_its_own_filter(logger):
    first = [logger.info("text", once=True) for _ in range(2)]
    second = [logger.info("text", once=True) for _ in range(2)]
    assert first == second == [True, False]


def test_a_line_of_code_keeps_its_severity(logger):
    with pytest.raises(ValueError, match="severity cannot be changed between calls"):
        for severity in (LoggingSeverity.INFO, LoggingSeverity.WARN):
            logger.log("text", severity)


def test_a_line_of_code_keeps_its_filters(logger):
    with pytest.raises(ValueError, match="filters cannot be changed between calls"):
        for once in (True, False):
            logger.info("text", once=once)


def test_a_line_of_code_keeps_its_filters_parameters(logger):
    with pytest.raises(ValueError, match="parameters cannot be changed between calls"):
        for seconds in (100, 200):
            logger.info("text", throttle_duration_sec=seconds)


def test_a_line_of_code_keeps_its_name(logger):
    with pytest.raises(ValueError, match="name cannot be changed between calls"):
        for name in ("a", "b"):
            logger.info("text", name=name)


def test_an_unknown_option_is_refused(logger):
    with pytest.raises(TypeError, match="is not one of the recognized logging options"):
        logger.info("text", loud=True)


def test_a_time_source_without_a_duration_is_refused(logger):
    with pytest.raises(TypeError, match="throttle_duration_sec"):
        logger.info("text", throttle_time_source_type=Clock())


def test_a_time_source_is_a_clock(logger):
    with pytest.raises(ValueError, match="is not a clock instance"):
        logger.info("text", throttle_duration_sec=1, throttle_time_source_type="SYSTEM_TIME")


def test_the_root_logger_has_no_name():
    assert RcutilsLogger().name == ""
    assert RcutilsLogger().get_child("a").name == "a"


def test_a_node_logs_to_rosout(world):
    node, heard = world.node("speaker", namespace="/ns"), []
    listener = world.node("listener")
    listener.create_subscription(Log, "/rosout", heard.append, 100)
    world.spin_until(lambda: listener.count_publishers("/rosout") >= 2)

    def told():
        node.get_logger().warning("careful")
        return any(message.msg == "careful" for message in heard)

    world.spin_until(told)
    (message, *_) = [each for each in heard if each.msg == "careful"]
    assert (message.name, message.level) == ("ns.speaker", 30)
    assert message.file.endswith("test_logging.py")
    assert message.function == "told"
    assert message.line > 0


def test_rosout_can_be_declined(world):
    node = world.node("quiet", enable_rosout=False)
    topics = [name for name, _ in node.get_publisher_names_and_types_by_node("quiet", "/")]
    assert "/rosout" not in topics


@pytest.mark.parametrize("words", [["--log-level", "t_cli:=debug"], ["--log-level", "T_CLI:=DEBUG"]])
def test_the_command_line_sets_levels(make_world, words):
    make_world(args=["--ros-args", *words])
    name = words[1].partition(":=")[0]
    assert rclpy.logging.get_logger_effective_level(name) == LoggingSeverity.DEBUG


def test_throttle_by_simulated_time_counts_from_zero(logger):
    clock = Clock(clock_type=ClockType.ROS_TIME)
    clock._set_ros_time_is_active(True)
    shown = []
    for second in (0, 1, 2, 3, 4):
        clock.set_ros_time_override(Time(seconds=second, clock_type=ClockType.ROS_TIME))
        shown.append(logger.info("text", throttle_duration_sec=2, throttle_time_source_type=clock))
    assert shown == [False, False, True, False, True]


def test_a_severity_is_no_option(logger):
    with pytest.raises(TypeError, match="got multiple values for argument 'severity'"):
        logger.fatal("text", severity=LoggingSeverity.DEBUG)


def test_the_logging_directory_is_named_by_the_environment(monkeypatch, tmp_path):
    for name in ("ROS_LOG_DIR", "ROS_HOME"):
        monkeypatch.delenv(name, raising=False)
    for name in ("HOME", "USERPROFILE"):  # the second on Windows
        monkeypatch.setenv(name, str(tmp_path))
    assert rclpy.logging.get_logging_directory() == tmp_path / ".ros" / "log"
    monkeypatch.setenv("ROS_HOME", str(tmp_path / "ros"))
    assert rclpy.logging.get_logging_directory() == tmp_path / "ros" / "log"
    monkeypatch.setenv("ROS_LOG_DIR", str(tmp_path / "logs"))
    assert rclpy.logging.get_logging_directory() == tmp_path / "logs"


MADE = ("Node i", "Publisher i", "Subscription i", "Client i", "Service i")
SAID_BY_RCL = ("Initializing ", "Using domain", "Expanded ", *MADE)
NOT_OF_THE_NODE = ("get_type_description", "wait set", "1000000000ns", "ROS client library")
"""Of releases after Humble, of an executor, and of the context."""


def test_rcl_says_what_it_makes(make_world, capfd):
    rclpy.logging.set_logger_level("rcl", LoggingSeverity.DEBUG)
    try:
        world = make_world(args=[])
        node = world.node("a", namespace="ns", start_parameter_services=False, enable_rosout=False)
        node.create_publisher(String, "chat", 1)
        node.create_subscription(String, "~/x", print, 1)
        node.create_client(Empty, "ask")
        node.create_service(Empty, "answer", print)
        node.create_timer(0.5, print)
        said = [match[3] for match in LINE.finditer(capfd.readouterr().err) if match[2] == "rcl"]
    finally:
        rclpy.logging.set_logger_level("rcl", LoggingSeverity.UNSET)
    lines = [line for line in said if line.startswith(SAID_BY_RCL) and not any(word in line for word in NOT_OF_THE_NODE)]
    assert lines[0] == "Initializing node 'a' in namespace 'ns'" and lines[1].startswith("Using domain ID of '")
    assert lines[2:6] == [
        "Node initialized",
        "Initializing publisher for topic name '/parameter_events'",
        "Expanded and remapped topic name '/parameter_events'",
        "Publisher initialized",
    ]
    services = [line for line in lines[6:] if line != "Service initialized"]
    assert services == [
        "Initializing publisher for topic name 'chat'",
        "Expanded and remapped topic name '/ns/chat'",
        "Publisher initialized",
        "Initializing subscription for topic name '~/x'",
        "Expanded and remapped topic name '/ns/a/x'",
        "Subscription initialized",
        "Initializing client for service name 'ask'",
        "Expanded and remapped service name '/ns/ask'",
        "Client initialized",
        "Initializing service for service name 'answer'",
        "Expanded and remapped service name '/ns/answer'",
        "Initializing timer with period: 500000000ns",
    ]
    assert lines.count("Service initialized") >= 1


def test_rcl_says_when_it_calls_a_timer(make_world, capfd):
    world = make_world(args=[])
    node = world.node("a", start_parameter_services=False, enable_rosout=False)
    called = []
    node.create_timer(0.01, lambda: called.append(1))
    rclpy.logging.set_logger_level("rcl", LoggingSeverity.DEBUG)
    try:
        world.spin_until(lambda: called)
        said = [match[3] for match in LINE.finditer(capfd.readouterr().err) if match[2] == "rcl"]
    finally:
        rclpy.logging.set_logger_level("rcl", LoggingSeverity.UNSET)
    assert said.count("Calling timer") == len(called)
