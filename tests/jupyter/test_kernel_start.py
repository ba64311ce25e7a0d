"""A kernel of the course has the lab from the first moment, without an import cell, and after a restart."""

import pytest
from jupyter_client.manager import KernelManager

from coursekit.jupyter.kernel import write_kernelspec

pytestmark = [pytest.mark.slow, pytest.mark.timeout(240)]


@pytest.fixture
def kernel(tmp_path, monkeypatch):
    """A kernel as `coursekit lab` starts it, on the virtual clock; kernel("code") gives what that prints."""
    monkeypatch.setenv("JUPYTER_PATH", str(write_kernelspec(tmp_path)))
    monkeypatch.setenv("COURSEKIT_COURSE", str(tmp_path / "course"))
    monkeypatch.setenv("COURSEKIT_WORKSPACE", str(tmp_path / "course" / "ros2_ws"))
    monkeypatch.setenv("COURSEKIT_TIME", "virtual")
    manager = KernelManager(kernel_name="python3")
    manager.start_kernel()
    client = manager.client()
    client.start_channels()
    client.wait_for_ready(timeout=60)

    def run(code):
        said = []
        client.execute_interactive(code, timeout=60, output_hook=lambda message: said.append(message["content"]))
        errors = ["\n".join(output["traceback"]) for output in said if "traceback" in output]
        return "".join(output.get("text", "") for output in said) + "".join(errors)

    run.manager, run.client = manager, client
    yield run
    client.stop_channels()
    manager.shutdown_kernel(now=True)


def restarted(kernel):
    kernel.manager.restart_kernel(now=True)
    kernel.client.wait_for_ready(timeout=60)


def test_the_names_and_magics_of_the_lab_are_there_at_every_start(kernel):
    for _ in range(2):
        assert kernel("%ros2 pkg prefix turtlesim --share").strip().endswith("turtlesim")
        assert kernel("%%write src/a.txt\nhello") == "Wrote ros2_ws/src/a.txt (1 lines)\n"
        assert kernel("print(graph, check, terminal, wait, reset)").count("<function") == 5
        assert kernel("from coursekit.lab import *\nreset()").startswith("Reset: nothing was running.")
        restarted(kernel)


def test_what_a_cell_starts_is_the_cell_s(kernel):
    kernel.client.session.metadata = {"cellId": "one"}
    line = "%ros2 run demo_nodes_py talker &"
    assert "Run again" not in kernel(line)
    assert kernel(line).startswith("Run again: replaced process `ros2 run demo_nodes_py talker`")


def test_a_real_kernel_keeps_the_output_of_threads_in_cells(kernel):
    assert kernel("print(get_ipython().set_parent.for_cells)") == "True\n"


INIT = "import rclpy\nrclpy.init()\nnode = rclpy.create_node('n')\nprint(node.get_name())"


def test_a_cell_that_initialises_rclpy_may_be_run_again(kernel):
    kernel.client.session.metadata = {"cellId": "one"}
    assert kernel(INIT) == "n\n"
    assert kernel(INIT) == "Run again: replaced node /n and rclpy.init().\nn\n"


def test_a_cell_that_initialises_rclpy_after_another_says_what_to_do(kernel):
    kernel.client.session.metadata = {"cellId": "one"}
    assert kernel(INIT) == "n\n"
    kernel.client.session.metadata = {"cellId": "two"}
    said = kernel(INIT)
    assert "Context.init() must only be called once" in said
    assert "Another cell has called rclpy.init() already. Leave it out here, or end all before it: reset()\n" in said
    assert kernel(INIT.replace("rclpy.init()", "reset()\nrclpy.init()")).endswith("n\n")


@pytest.mark.parametrize(
    ("code", "says"),
    [
        ("node.declare_parameter('a', 1)\nnode.declare_parameter('a', 1)", "The node has this parameter since"),
        ("rclpy.shutdown()\nrclpy.shutdown()", "this cell has nothing left to do"),
        ("rclpy.shutdown()\nrclpy.spin_once(node)", "from the one with rclpy.init() on"),
        ("rclpy.shutdown()\nrclpy.create_node('n')", "from the one with rclpy.init() on"),
        ("from std_msgs.msg import String\np = node.create_publisher(String, 'a', 1)\nrclpy.shutdown()\np.publish(String())",
         "from the one with rclpy.init() on"),
    ],
)  # fmt: skip
def test_an_error_of_cells_in_another_order_says_what_to_do(kernel, code, says):
    kernel(INIT)
    assert says in kernel(code)


def test_a_lab_that_cannot_start_says_so_in_the_first_cell_and_python_still_runs(kernel, monkeypatch):
    monkeypatch.setenv("COURSEKIT_TIME", "no such clock")
    restarted(kernel)
    first = kernel("print(1 + 1)")
    assert "The lab did not start" in first and "coursekit doctor" in first and "2\n" in first
    assert kernel("print(3)") == "3\n"
