import pytest
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.parameter import Parameter, parameter_value_to_python
from rclpy.parameter_client import AsyncParameterClient


@pytest.fixture
def served(world):
    node = world.node("server")
    node.declare_parameters("", [("a", 1), ("b.c", 2.5), ("b.d.e", "x"), ("z", True)])
    node.declare_parameter("fixed", 1, ParameterDescriptor(read_only=True, description="stays"))
    asker = world.node("asker")
    client = AsyncParameterClient(asker, "/server")
    assert client.wait_for_services(timeout_sec=8.0)
    assert client.services_are_ready()
    return world, node, client


def test_six_services_are_there(served):
    _world, node, _ = served
    names = {name for name, _ in node.get_service_names_and_types_by_node("server", "/")}
    kinds = ("describe_parameters", "get_parameters", "get_parameter_types")
    kinds += ("list_parameters", "set_parameters", "set_parameters_atomically")
    assert {f"/server/{kind}" for kind in kinds} <= names


def test_they_can_be_declined(world):
    node = world.node("quiet", start_parameter_services=False)
    names = [name for name, _ in node.get_service_names_and_types_by_node("quiet", "/")]
    assert "/quiet/get_parameters" not in names


def test_values_are_told(served):
    world, _, client = served
    values = world.result(client.get_parameters(["a", "b.c"])).values
    assert [parameter_value_to_python(value) for value in values] == [1, 2.5]


def test_an_unknown_name_empties_the_answer(served):
    world, _, client = served
    assert world.result(client.get_parameters(["a", "absent"])).values == []
    assert world.result(client.describe_parameters(["a", "absent"])).descriptors == []


def test_types_and_descriptors_are_told(served):
    world, _, client = served
    assert list(world.result(client.get_parameter_types(["a", "z"])).types) == [2, 1]
    (descriptor,) = world.result(client.describe_parameters(["fixed"])).descriptors
    assert (descriptor.name, descriptor.read_only, descriptor.description) == ("fixed", True, "stays")


def test_values_are_set_each_for_itself(served):
    world, node, client = served
    parameters = [Parameter("a", value=5), Parameter("absent", value=1), Parameter("fixed", value=2)]
    results = world.result(client.set_parameters(parameters)).results
    assert [result.successful for result in results] == [True, False, False]
    assert node.get_parameter("a").value == 5


def test_values_are_set_all_or_none(served):
    world, node, client = served
    parameters = [Parameter("a", value=5), Parameter("z", value="text")]
    assert not world.result(client.set_parameters_atomically(parameters)).result.successful
    assert node.get_parameter("a").value == 1
    parameters = [Parameter("a", value=5), Parameter("z", value=False)]
    assert world.result(client.set_parameters_atomically(parameters)).result.successful


@pytest.mark.parametrize(
    ("prefixes", "depth", "names", "found_prefixes"),
    [
        ([], 1, {"a", "z", "fixed", "use_sim_time"}, []),
        (["b"], 0, {"b.c", "b.d.e"}, ["b", "b.d"]),
        (["b"], 1, {"b.c"}, ["b"]),
        (["b"], 2, {"b.c", "b.d.e"}, ["b", "b.d"]),
        (["a", "b"], 1, {"a", "b.c"}, ["b"]),
        (["absent"], 0, set(), []),
    ],
)
def test_names_are_listed(served, prefixes, depth, names, found_prefixes):
    world, _, client = served
    result = world.result(client.list_parameters(prefixes, depth)).result
    assert {name for name in result.names if name != "start_type_description_service"} == names
    assert list(result.prefixes) == found_prefixes


def test_a_file_is_loaded(served, tmp_path):
    world, node, client = served
    file = tmp_path / "p.yaml"
    file.write_text("/server:\n  ros__parameters:\n    a: 8\n    b: {c: 3.5}\n")
    results = world.result(client.load_parameter_file(str(file))).results
    assert all(result.successful for result in results)
    assert [p.value for p in node.get_parameters(["a", "b.c"])] == [8, 3.5]


@pytest.mark.humble_only("a later client leaves out the values of other nodes")
@pytest.mark.parametrize("way", ["load_parameter_file", "load_parameter_file_atomically"])
def test_a_file_is_loaded_whole_whichever_nodes_it_names(served, tmp_path, way):
    world, node, client = served
    file = tmp_path / "p.yaml"
    file.write_text("/somebody:\n  ros__parameters: {a: 8}\n/else:\n  ros__parameters: {b: {c: 3.5}}\n")
    world.result(getattr(client, way)(str(file)))
    assert [p.value for p in node.get_parameters(["a", "b.c"])] == [8, 3.5]


def test_callbacks_get_the_future(served):
    world, _, client = served
    seen = []
    future = client.get_parameters(["a"], callback=seen.append)
    world.result(future)
    world.spin_until(lambda: seen)
    assert seen == [future]


def test_absent_services_are_not_ready(world):
    client = AsyncParameterClient(world.node(), "/absent")
    assert not client.services_are_ready()
    assert not client.wait_for_services(timeout_sec=0.1)
