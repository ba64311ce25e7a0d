import pytest
from rclpy.utilities import remove_ros_args
from std_msgs.msg import String
from std_srvs.srv import Trigger


def args(*rules):
    return ["--ros-args"] + [word for rule in rules for word in ("-r", rule)]


@pytest.mark.parametrize(
    ("rules", "name", "full"),
    [
        (["a:=b"], "a", "/s/b"),
        (["a:=b", "b:=c"], "a", "/s/b"),
        (["a:=b", "a:=c"], "a", "/s/b"),
        (["/s/a:=b"], "a", "/s/b"),
        (["/a:=b"], "a", "/s/a"),
        (["a:=/b"], "/s/a", "/b"),
        (["~/a:=b"], "~/a", "/s/b"),
        (["~/a:=b"], "/s/n/a", "/s/b"),
        (["a:=~/b"], "a", "/s/n/b"),
        (["n:a:=b"], "a", "/s/b"),
        (["m:a:=b"], "a", "/s/a"),
        (["rostopic://a:=b"], "a", "/s/b"),
        (["rosservice://a:=b"], "a", "/s/a"),
        (["x/a:=b/c"], "x/a", "/s/b/c"),
        (["a:=b"], "x/a", "/s/x/a"),
        (["__node:=m"], "~/a", "/s/m/a"),
        (["__node:=m", "m:a:=b"], "a", "/s/b"),
        (["__node:=m", "n:a:=b"], "a", "/s/a"),
        (["__ns:=/t", "a:=b"], "a", "/t/b"),
        (["__ns:=/t", "/s/a:=b"], "a", "/t/a"),
    ],
)
def test_topics_are_renamed(world, rules, name, full):
    node = world.node("n", namespace="/s", cli_args=args(*rules), spin=False)
    assert node.resolve_topic_name(name) == full


@pytest.mark.parametrize(
    ("rules", "full"),
    [(["a:=b"], "/s/b"), (["rosservice://a:=b"], "/s/b"), (["rostopic://a:=b"], "/s/a")],
)
def test_services_are_renamed(world, rules, full):
    node = world.node("n", namespace="/s", cli_args=args(*rules), spin=False)
    assert node.resolve_service_name("a") == full


def test_only_expanding_leaves_the_rules_out(world):
    node = world.node("n", cli_args=args("a:=b"), spin=False)
    assert node.resolve_topic_name("a", only_expand=True) == "/a"
    assert node.resolve_service_name("a", only_expand=True) == "/a"


def test_entities_have_their_new_names(world):
    node = world.node("n", cli_args=args("chatter:=news", "go:=run"))
    assert node.create_publisher(String, "chatter", 10).topic_name == "/news"
    assert node.create_subscription(String, "chatter", lambda m: None, 10).topic_name == "/news"
    assert node.create_service(Trigger, "go", lambda q, r: r).service_name == "/run"
    assert node.create_client(Trigger, "go").service_name == "/run"


def test_the_oldest_way_of_remapping_still_works(make_world, capfd):
    world = make_world(args=["x", "a:=b"])
    assert world.node("n").resolve_topic_name("a") == "/b"
    assert "Found remap rule 'a:=b'. This syntax is deprecated." in capfd.readouterr().err


def test_rules_of_the_process_are_for_all_its_nodes(make_world):
    world = make_world(args=args("a:=b", "n:c:=d"))
    assert world.node("n").resolve_topic_name("a") == "/b"
    assert world.node("m").resolve_topic_name("a") == "/b"
    assert world.node("n").resolve_topic_name("c") == "/d"
    assert world.node("m").resolve_topic_name("c") == "/c"


def test_rules_of_the_node_come_first(make_world):
    world = make_world(args=args("a:=general"))
    assert world.node("n", cli_args=args("a:=own")).resolve_topic_name("a") == "/own"


@pytest.mark.parametrize(
    ("words", "rest"),
    [
        (
            ["x", "--ros-args", "-r", "a:=b", "--", "y", "--ros-args", "-p", "c:=1", "--", "z"],
            ["x", "y", "z"],
        ),
        (["x", "--", "y"], ["x", "--", "y"]),
        (["x", "a:=b"], ["x"]),
        (["x", "--ros-args", "--", "--"], ["x", "--"]),
    ],
)
def test_other_words_are_left(words, rest):
    assert remove_ros_args(words) == rest


@pytest.mark.parametrize("rule", ["a", "a:=", ":=b", "a:=b c", "__ns:=x", "a/*:=b", "{node}:=b", "1a:=b"])
def test_bad_rules_are_refused(world, rule):
    with pytest.raises(RuntimeError, match="Couldn't parse remap rule"):
        world.node("n", cli_args=args(rule))
