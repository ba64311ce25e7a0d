"""What nav2 says and does with a workspace's plugins: all of it in the course's warehouse, on the virtual clock."""

from __future__ import annotations

import re
import textwrap
from pathlib import Path

import yaml

from coursekit.interfaces.find import UNDERLAY
from tests.packages.test_cpp_workspace import scripted

ROOT = Path(__file__).parents[2]
PARAMETERS = UNDERLAY / "share" / "nav2_bringup" / "params" / "nav2_params.yaml"
STAGE = """
import sys
from pathlib import Path

sys.path.insert(0, ROOT)
from action_msgs.msg import GoalStatus
from coursekit.geometry.plane import Pose2D
from coursekit.processes.session import Session
from nav2_msgs.action import ComputePathThroughPoses, ComputePathToPose, FollowPath, NavigateToPose
from rclpy.action import ActionClient
from tests.nodes.nav2_stage import ROBOT, Stage

STATUS = {1: "accepted", 2: "executing", 4: "succeeded", 5: "canceled", 6: "aborted"}


def ask(kind, name, **fields):
    client = ActionClient(stage.node, kind, name)
    if not client.wait_for_server(timeout_sec=5.0):
        return None
    handle = stage.until(client.send_goal_async(kind.Goal(**fields)))
    answer = stage.until(handle.get_result_async())
    print(name, STATUS[answer.status])
    return answer.result


def at(x, y, theta=0.0):
    return stage.stamped(Pose2D(x, y, theta))


with (session := Session(virtual=True)).use():
    stage = Stage(session, Path("."), "tec_warehouse", ROBOT, "params_file:=parameters.yaml")
    stage.tell_pose(Pose2D(0.0, 0.0, 0.0))
    BODY
    stage.close()
print(stage.launch.output)
"""


def told(folder, body, **changed):
    """What the script prints, and then nav2, without stamps; `changed` are parameters of servers."""
    parameters = yaml.safe_load(PARAMETERS.read_text())
    for server, values in changed.items():
        inner = parameters[server].get(server, parameters[server])
        inner["ros__parameters"].update(values)
    (folder / "parameters.yaml").write_text(yaml.safe_dump(parameters))
    text = STAGE.replace("BODY", textwrap.indent(textwrap.dedent(body), "    ").strip())
    done = scripted(folder, f"ROOT = {str(ROOT)!r}\n{text}")
    assert done.returncode == 0, done.stdout + done.stderr
    return re.sub(r"\[\d+\.\d+\] ", "", done.stdout)


def lines(text, node):
    """The level and text of a node's lines."""
    return re.findall(rf"\[(INFO|WARN|ERROR|FATAL)\] \[{node}\]: (.*)", text)
