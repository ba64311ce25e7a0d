import pytest

from coursekit.rcl import arguments
from coursekit.rcl.arguments import merge, parse_ros_arguments, remove_ros_arguments

ROS = "--ros-args"


def remapped(rules, name, kind="topic", node="n", namespace="/s"):
    words = [ROS] + [word for rule in rules for word in ("-r", rule)]
    return parse_ros_arguments(words).remap(kind, name, node, namespace)


@pytest.mark.parametrize(
    ("rules", "name", "expected"),
    [
        (["a:=b"], "/s/a", "/s/b"),
        (["a:=b", "b:=c"], "/s/a", "/s/b"),
        (["a:=b", "a:=c"], "/s/a", "/s/b"),
        (["/s/a:=b"], "/s/a", "/s/b"),
        (["/a:=b"], "/s/a", "/s/a"),
        (["~/a:=b"], "/s/n/a", "/s/b"),
        (["a:=/b"], "/s/a", "/b"),
        (["a:=~/b"], "/s/a", "/s/n/b"),
        (["n:a:=b"], "/s/a", "/s/b"),
        (["m:a:=b"], "/s/a", "/s/a"),
        (["rostopic://a:=b"], "/s/a", "/s/b"),
        (["rosservice://a:=b"], "/s/a", "/s/a"),
        (["n:rostopic://a:=b"], "/s/a", "/s/b"),
        (["x/a:=b/c"], "/s/x/a", "/s/b/c"),
    ],
)
def test_the_first_matching_rule_renames_a_topic(rules, name, expected):
    assert remapped(rules, name) == expected


def test_a_service_rule_renames_services_only():
    assert remapped(["rosservice://a:=b"], "/s/a", "service") == "/s/b"
    assert remapped(["rostopic://a:=b"], "/s/a", "service") == "/s/a"


def test_node_name_and_namespace_follow_their_rules():
    parsed = parse_ros_arguments([ROS, "-r", "__node:=m", "-r", "m:__ns:=/t", "-r", "__node:=k"])
    assert parsed.node_name("n") == "m"
    assert parsed.node_namespace("m", "/") == "/t"
    assert parsed.node_namespace("n", "/") == "/"
    assert parse_ros_arguments([ROS, "-r", "other:__name:=m"]).node_name("n") == "n"


def test_rules_of_the_node_come_before_those_of_the_process():
    local = parse_ros_arguments([ROS, "-r", "a:=own", "-p", "x:=1"])
    general = parse_ros_arguments([ROS, "-r", "a:=other", "-r", "b:=c", "-p", "x:=2", "-p", "y:=3"])
    both = merge(local, general)
    assert both.remap("topic", "/a", "n", "/") == "/own"
    assert both.remap("topic", "/b", "n", "/") == "/c"
    assert both.parameters_for("/n") == {"x": 1, "y": 3}


def test_parameters_apply_in_the_order_given(tmp_path):
    file = tmp_path / "p.yaml"
    file.write_text("/**:\n  ros__parameters:\n    a: 1\n")
    words = ["--params-file", str(file)]
    assert parse_ros_arguments([ROS, *words, "-p", "a:=2"]).parameters_for("/n") == {"a": 2}
    assert parse_ros_arguments([ROS, "-p", "a:=2", *words]).parameters_for("/n") == {"a": 1}


def test_a_scoped_parameter_is_for_the_node_in_the_root_namespace():
    parsed = parse_ros_arguments([ROS, "-p", "m:a:=2", "-p", "n:b:=3"])
    assert parsed.parameters_for("/n") == {"b": 3}
    assert parsed.parameters_for("/s/n") == {}
    assert parsed.overrides == (("/m", "a", 2), ("/n", "b", 3))


@pytest.mark.parametrize("name", ["a", "a.b.c", "/a/b", "a__b", "_a", "a/", "a./b.c"])
def test_these_are_parameter_names(name):
    assert parse_ros_arguments([ROS, "-p", f"{name}:=x:=y"]).parameters_for("/n") == {name: "x:=y"}


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["-r"], "Couldn't parse trailing -r flag. No remap rule found."),
        (["-r", "a"], "Couldn't parse remap rule: '-r a'. Error: "),
        (["-r", "a:="], "Couldn't parse remap rule: '-r a:='. Error: "),
        (["--remap", "a/*:=b"], "Couldn't parse remap rule: '--remap a/*:=b'. Error: Wildcard '*' is"),
        (["-r", "__ns:=x"], "Couldn't parse remap rule: '-r __ns:=x'. Error: "),
        (["-r", "__foo:=x"], "Couldn't parse remap rule: '-r __foo:=x'. Error: Expecting token or wildcard"),
        (["-r", "a:=rostopic://b"], "Couldn't parse remap rule"),
        (["-p"], "Couldn't parse trailing -p flag. No parameter override rule found."),
        (["-p", "1a:=1"], "Couldn't parse parameter override rule: '-p 1a:=1'. Error: "),
        (["-p", "a:=[1,x]"], "Value type 'string' do not belong at line_num 1"),
        (["-p", "a:={b: 1}"], "Unknown YAML event"),
        (["--params-file", "/nope.yaml"], "Couldn't parse params file: '--params-file /nope.yaml'. Error: "),
        (["--log-level"], "Couldn't parse trailing log level flag: '--log-level'. No log level provided."),
        (["--log-level", "loud"], "Couldn't parse log level: '--log-level loud'. Error: Argument does"),
        (["-e", "a b"], "Enclave name is not valid: 'context name must be absolute, it must lead"),
        (["--log-config-file"], "Couldn't parse trailing --log-config-file flag. No file path provided."),
    ],
)
def test_a_rule_that_cannot_be_read_is_refused_in_rcls_words(words, text):
    with pytest.raises(arguments.RosArgumentsError) as caught:
        parse_ros_arguments([ROS, *words])
    assert text in str(caught.value)


def test_unknown_flags_are_listed():
    with pytest.raises(arguments.UnknownRosArguments) as caught:
        parse_ros_arguments(["x", ROS, "--foo", "bar", "--", "z"])
    assert str(caught.value) == "['--foo', 'bar']"


def test_sections_chain_and_leave_the_other_words():
    words = ["x", ROS, "-r", "a:=b", "--", "y", ROS, "-p", "c:=1", "--", "z"]
    assert remove_ros_arguments(words) == ["x", "y", "z"]
    assert parse_ros_arguments(words).parameters_for("/n") == {"c": 1}
    assert remove_ros_arguments(["p", "--", "b"]) == ["p", "--", "b"]


def test_a_bare_remap_rule_still_counts():
    parsed = parse_ros_arguments(["p", "a:=b"])
    assert parsed.remap("topic", "/a", "n", "/") == "/b"
    assert parsed.unparsed == ("p",)
    assert "This syntax is deprecated" in parsed.warnings[0]


def test_log_levels_and_switches_are_kept():
    words = [ROS, "--log-level", "Warn", "--log-level", "a.b:=debug", "--disable-rosout-logs"]
    parsed = parse_ros_arguments([*words, "--disable-stdout-logs", "--enclave", "/x"])
    assert parsed.log_levels == {None: 30, "a.b": 10}
    assert (parsed.rosout_enabled, parsed.stdout_enabled, parsed.enclave) == (False, False, "/x")


def test_no_arguments_say_nothing():
    assert parse_ros_arguments(None) == parse_ros_arguments([])
