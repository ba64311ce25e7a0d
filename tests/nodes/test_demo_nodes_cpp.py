"""What demo_nodes_cpp's executables print, as Humble's do."""

import pytest

from tests.nodes.log import said

EVENT = "\nParameter event:\n new parameters:{}\n changed parameters:{}\n deleted parameters:\n"


@pytest.mark.parametrize("timer", ["one_off_timer", "reuse_timer"])
def test_a_timer_rings_once_for_every_three_rings_of_the_other(session, run, timer):
    process = run("demo_nodes_cpp", timer)
    session.clock.sleep(8.5)
    first = ["in periodic_timer callback", "  resetting one off timer", "in one_off_timer callback"]
    others = ["in periodic_timer callback", "  not resetting one off timer"]
    assert said(process) == [*first, *others, *others, *first[:2]]


@pytest.mark.parametrize("name", ["list_parameters", "list_parameters_async"])
def test_own_parameters_are_listed(run, name):
    process = run("demo_nodes_cpp", name)
    assert process.wait(5) == 0
    assert said(process)[:2] == ["Setting parameters...", "Listing parameters..."]
    assert process.output.endswith(
        "\nParameter names:\n bar\n foo\n foo.first\n foo.second\nParameter prefixes:\n foo\n"
    )


@pytest.mark.parametrize("name", ["set_and_get_parameters", "set_and_get_parameters_async"])
def test_own_parameters_are_told_as_cpp_writes_them(run, name):
    process = run("demo_nodes_cpp", name)
    assert process.wait(5) == 0
    assert process.output.split("]: ", 1)[1] == (
        "\nParameter name: foo\nParameter value (integer): 2\nParameter name: baz\nParameter value (double): 1.450000"
        "\nParameter name: foobarbaz\nParameter value (bool_array): [true, false]"
        "\nParameter name: toto\nParameter value (byte_array): [0xff, 0x7f]\n"
    )


@pytest.mark.parametrize("name", ["parameter_events", "parameter_events_async"])
def test_each_change_of_a_parameter_is_an_event(run, name):
    process = run("demo_nodes_cpp", name)
    assert process.wait(5) == 0
    names = ["foo", "bar", "baz", "foobar"]
    expected = [EVENT.format(f"\n  {parameter_name}", "") for parameter_name in names]
    expected += [EVENT.format("", f"\n  {parameter_name}") for parameter_name in [*names, "foo", "bar"]]
    told = [text.rpartition("[INFO]")[0] or text for text in process.output.split("]: ")[1:]]
    assert [text.rstrip("\n") for text in told] == [text.rstrip("\n") for text in expected]


def test_only_even_parameters_are_taken(session, run, ros2):
    process = run("demo_nodes_cpp", "even_parameters_node")
    session.clock.sleep(0.1)
    node = "/even_parameters_node"
    assert ros2("param", "set", node, "myint", "2") == "Set parameter successful\n"
    refused = "Setting parameter failed: "
    assert ros2("param", "set", node, "myint", "3") == f"{refused}only even integers can be set\n"
    assert ros2("param", "set", node, "text", "two") == f"{refused}only integer parameters can be set\n"
    assert "parameter 'myint' has changed and is now: 2" in process.output
    assert "Requested value '3' for parameter 'myint' is not an even number: rejecting change..." in process.output


def test_callbacks_hear_of_their_own_and_of_another_nodes_parameters(session, run, ros2):
    process = run("demo_nodes_cpp", "parameter_event_handler")
    session.clock.sleep(0.1)
    ros2("param", "set", "this_node", "an_int_param", "21")
    ros2("param", "set", "/a_namespace/a_remote_node", "a_string_param", "string value to set")
    new = 'Received an update to parameter "a_string_param" of type: string: "string value to set"'
    mine = 'Received an update to parameter "an_int_param" of type: integer: "21"'
    assert said(process)[-4:] == [f"cb3: {mine}", f"cb2: {new}", f"cb3: {new}", f"cb3: {new}"]
    assert 'cb1: Received an update to parameter "an_int_param" of type integer: "21"' in process.output


def test_serialized_messages_are_shown_as_bytes_at_both_ends(session, run):
    talker = run("demo_nodes_cpp", "talker_serialized_message")
    listener = run("demo_nodes_cpp", "listener_serialized_message")
    session.clock.sleep(1.5)
    data = "00 01 00 00 0e 00 00 00 48 65 6c 6c 6f 20 57 6f 72 6c 64 3a 31 00 "
    assert talker.output == f"ROS message:\nHello World:1\nserialized message:\n{data}\n"
    assert listener.output == (
        f"I heard data of length: 22\n{data}\nserialized data after deserialization: Hello World:1\n"
    )


def test_only_emergencies_reach_the_listener(session, run):
    run("demo_nodes_cpp", "content_filtering_publisher", "--ros-args", "-p", "publish_ms:=100")
    listener = run("demo_nodes_cpp", "content_filtering_subscriber")
    session.clock.sleep(2.65)
    told, *heard = said(listener)
    assert told.endswith('with content filter options "data < %0 OR data > %1, {-30.000000, 100.000000}"')
    degrees = [float(line.split("[")[1].rstrip("]")) for line in heard]
    assert degrees == [-100, -90, -80, -70, -60, -50, -40, 110, 120, 130, 140, 150]


def test_numbers_and_texts_are_published_in_turn_and_heard_with_best_effort(session, run):
    talker, listener = run("demo_nodes_cpp", "talker_loaned_message"), run("demo_nodes_cpp", "listener_best_effort")
    session.clock.sleep(2.5)
    first, second, *others = (
        f"Publishing: '{text}'" for text in ("1.000000", "Hello World: 2", "3.000000", "Hello World: 4")
    )
    none_lent = "Currently used middleware can't loan messages. Local allocator will be used."
    assert said(talker) == [none_lent, first, none_lent, second, *others]
    assert said(listener) == ["I heard: [Hello World: 2]", "I heard: [Hello World: 4]"]


@pytest.mark.parametrize("name", ["add_two_ints_client", "add_two_ints_client_async"])
def test_a_client_waits_for_the_server_and_tells_the_sum(session, run, name):
    client = run("demo_nodes_cpp", name)
    session.clock.sleep(1.5)
    run("demo_nodes_cpp", "add_two_ints_server")
    assert client.wait(5) == 0
    assert said(client) == ["service not available, waiting again...", "Result of add_two_ints: 5"]


def test_what_is_left_out_is_said(ros2):
    assert "it counts what C++ allocates" in ros2("run", "demo_nodes_cpp", "allocator_tutorial")


@pytest.mark.parametrize("ending", ["_launch.py", ".launch.py", "_launch.xml", "_launch.yaml"])
def test_talker_and_best_effort_listener_are_launched(ros2, ending):
    output = ros2("launch", "demo_nodes_cpp", f"talker_listener_best_effort{ending}", seconds=1.5)
    assert "[listener_best_effort-2] [INFO]" in output and "I heard: [Hello World: 1]" in output


def test_server_and_asynchronous_client_are_launched(ros2):
    output = ros2("launch", "demo_nodes_cpp", "add_two_ints_async_launch.py", seconds=2.5)
    assert "[add_two_ints_client_async-2]: process has finished cleanly" in output and "Result of add_two_ints: 5" in output


@pytest.mark.parametrize(("package", "code"), [("demo_nodes_cpp", 0), ("demo_nodes_py", 1)])
@pytest.mark.parametrize("name", ["talker", "listener", "add_two_ints_server"])
def test_a_program_in_cpp_ends_well_when_it_is_told_to_and_one_in_python_does_not(session, run, package, code, name):
    process = run(package, name)
    session.clock.sleep(0.1)
    process.terminate()
    assert process.wait(2) == code
