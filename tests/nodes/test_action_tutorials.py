from coursekit.cli.parser import run
from coursekit.core.executables import find
from coursekit.core.session import Session


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
