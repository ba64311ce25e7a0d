import pytest
from rclpy.exceptions import InvalidNamespaceException, InvalidNodeNameException


def test_a_node_has_a_name_and_the_root_namespace(world):
    node = world.node("talker")
    assert node.get_name() == "talker"
    assert node.get_namespace() == "/"
    assert node.get_fully_qualified_name() == "/talker"


@pytest.mark.parametrize(("given", "found"), [("ns", "/ns"), ("/ns", "/ns"), ("/a/b", "/a/b"), ("", "/")])
def test_a_namespace_is_made_absolute(world, given, found):
    assert world.node("n", namespace=given).get_namespace() == found


@pytest.mark.parametrize("name", ["", "a b", "1a", "a/b", "a-b", "n?"])
def test_a_bad_node_name_is_refused(world, name):
    with pytest.raises(InvalidNodeNameException):
        world.node(name)


def test_a_bad_name_is_pointed_at(world):
    with pytest.raises(InvalidNodeNameException) as caught:
        world.node("a b")
    lines = str(caught.value).splitlines()
    assert lines[1:] == ["  'a b'", "    ^"]
    assert "must not contain characters" in lines[0]


@pytest.mark.parametrize("namespace", ["/1", "/a b", "/a//b", "/a/"])
def test_a_bad_namespace_is_refused(world, namespace):
    with pytest.raises(InvalidNamespaceException):
        world.node("n", namespace=namespace)


def test_the_logger_has_the_dotted_name(world):
    assert world.node("n", namespace="/a/b").get_logger().name == "a.b.n"
    assert world.node("m").get_logger().name == "m"


def test_two_nodes_may_share_a_name(world):
    one, two = world.node("same"), world.node("same")
    world.spin_until(lambda: one.get_node_names().count("same") == 2)
    assert one is not two


def test_destroying_a_node_takes_it_out_of_the_graph(world):
    node, other = world.node("here"), world.node("gone")
    world.spin_until(lambda: "gone" in node.get_node_names())
    world.executor.remove_node(other)
    other.destroy_node()
    world.spin_until(lambda: "gone" not in node.get_node_names())


def test_a_node_may_be_destroyed_twice(world):
    node = world.node("n", spin=False)
    node.destroy_node()
    node.destroy_node()


@pytest.mark.parametrize(
    ("rule", "name", "namespace"),
    [
        ("__node:=other", "other", "/"),
        ("__name:=other", "other", "/"),
        ("__ns:=/there", "n", "/there"),
        ("n:__node:=other", "other", "/"),
        ("m:__node:=other", "n", "/"),
    ],
)
def test_remapping_renames_a_node(world, rule, name, namespace):
    node = world.node("n", cli_args=["--ros-args", "-r", rule])
    assert (node.get_name(), node.get_namespace()) == (name, namespace)


def test_use_global_arguments_can_be_declined(make_world):
    world = make_world(args=["--ros-args", "-r", "__node:=other"])
    assert world.node("n").get_name() == "other"
    assert world.node("n", use_global_arguments=False).get_name() == "n"
