"""nav2's tree nodes that cancel what a server is at."""

import rclpy
from action_msgs.srv import CancelGoal
from rclpy.node import Node

from coursekit.nav.behavior_tree import RUNNING, SUCCESS, read_tree
from coursekit.nodes.nav2.tree_context import TreeContext
from coursekit.nodes.nav2.tree_run import KINDS
from coursekit.processes.session import Session


def test_all_goals_up_to_now_are_canceled():
    with Session(virtual=True).use():
        rclpy.init()
        node, asked = Node("navigator"), []
        for server in ("follow_path", "my_wait"):
            node.create_service(
                CancelGoal, f"{server}/_action/cancel_goal", lambda q, a, server=server: asked.append((server, q)) or a
            )
        tree_context = TreeContext(node, lambda: None, lambda pose: None, lambda target, source: False)
        text = '<Sequence><CancelControl/><CancelWait server_name="my_wait"/></Sequence>'
        tree = read_tree(f'<root><BehaviorTree ID="Main">{text}</BehaviorTree></root>', KINDS, {"node": tree_context})
        status = RUNNING
        for _ in range(20):
            if status == RUNNING:
                status = tree.tick()
                rclpy.spin_once(node, timeout_sec=0.1)
        assert status == SUCCESS and [server for server, _ in asked] == ["follow_path", "my_wait"]
        request = asked[0][1].goal_info
        assert not any(request.goal_id.uuid) and request.stamp.sec > 0, "no id and a time: all goals before it"
        rclpy.shutdown()
