import pytest

from coursekit.cli.parser import run
from coursekit.processes.executables import find
from coursekit.processes.session import Session


def test_the_action_tutorial_counts_up_to_its_result():
    with Session(virtual=True).use() as session:
        server = session.start_executable(find("action_tutorials_py", "fibonacci_action_server"))
        client = session.start_executable(find("action_tutorials_py", "fibonacci_action_client"))
        assert client.wait(20) == 0
        heard = [line for line in client.output.splitlines() if "Received feedback" in line]
        assert len(heard) == 9
        assert "Result: array('i', [0, 1, 1, 2, 3, 5, 8, 13, 21, 34, 55])" in client.output
        server.interrupt()
        assert server.wait(5) == 0


def test_the_blackboard_takes_parameters_that_nobody_declared():
    with Session(virtual=True).use() as session:
        blackboard = find("demo_nodes_cpp", "parameter_blackboard")
        board = session.start_executable(blackboard, ["--ros-args", "-p", "colour:=blue"])
        session.clock.sleep(1)
        answers = []
        for words in (["set", "/parameter_blackboard", "wheels", "4"], ["list", "/parameter_blackboard"]):
            asked = session.start(lambda words=words: run(["param", *words]), name="ros2")
            asked.wait(10)
            answers.append(asked.output)
        assert answers[0] == "Set parameter successful\n"
        assert "  colour\n" in answers[1] and "  wheels\n" in answers[1]
        assert "ready, and serving '6' services already!" in board.output


def test_the_parameter_client_sets_loads_and_deletes():
    with Session(virtual=True).use() as session:
        session.start_executable(find("demo_nodes_cpp", "parameter_blackboard"))
        client = session.start_executable(find("demo_nodes_py", "async_param_client"))
        assert client.wait(20) == 0
        said = [line.split("]: ", 1)[1] for line in client.output.splitlines()]
        assert said.count("        successful: True") == 3 + 5 + 3
        assert "    - int_parameter: 10" in said and "        value: 12" in said


def test_the_parameter_client_says_what_it_waits_for():
    with Session(virtual=True).use() as session:
        client = session.start_executable(find("demo_nodes_py", "async_param_client"))
        assert client.wait(20) == 1
        assert "ros2 run demo_nodes_cpp parameter_blackboard" in client.output


def test_a_raw_listener_gets_the_bytes():
    with Session(virtual=True).use() as session:
        listener = session.start_executable(find("demo_nodes_py", "listener_serialized"))
        session.start_executable(find("demo_nodes_py", "talker"))
        session.clock.sleep(2)
        assert r'I heard: "b' in listener.output and r"\x00\x01\x00\x00\x0f\x00\x00\x00Hello World: 0\x00" in listener.output


@pytest.mark.parametrize("ending", [".launch.py", "_launch.py", "_launch.xml", "_launch.yaml"])
def test_launch_files_of_the_demos_start_a_talker_and_a_listener(ending):
    with Session(virtual=True).use() as session:
        words = ["launch", "demo_nodes_cpp", f"talker_listener{ending}"]
        launch = session.start(lambda: run(words), name="ros2")
        session.clock.sleep(2.5)
        launch.interrupt()
        launch.wait(10)
        assert "[talker]: Publishing: 'Hello World: 1'" in launch.output
        assert "[listener]: I heard: [Hello World: 1]" in launch.output


@pytest.mark.parametrize("ending", [".launch.py", "_launch.py"])
def test_launch_files_of_the_demos_add_two_numbers(ending):
    with Session(virtual=True).use() as session:
        launch = session.start(lambda: run(["launch", "demo_nodes_cpp", f"add_two_ints{ending}"]), name="ros2")
        session.clock.sleep(2.5)
        launch.interrupt()
        launch.wait(10)
        assert "Result of add_two_ints: 5" in launch.output
