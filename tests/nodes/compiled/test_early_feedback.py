"""Feedback that is taken before the answer to its goal reaches a compiled program after the answer."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
import rclpy
from action_tutorials_interfaces.action import Fibonacci

from coursekit.interfaces.cdr import serialize
from coursekit.nodes.compiled.actions import CompiledActionClient
from coursekit.processes.session import Session

HANDLERS = ANSWER, FEEDBACK, RESULT, CANCEL = 1, 2, 3, 4


@pytest.fixture
def node() -> Any:
    with Session(virtual=True).use():
        rclpy.init()
        yield rclpy.create_node("hasty")
        rclpy.shutdown()


def test_the_program_knows_the_goal_first(node: Any) -> None:
    tellings = node.create_publisher(Fibonacci.Impl.FeedbackMessage, "count/_action/feedback", 10)

    def take(request: Any, response: Any) -> Any:
        tellings.publish(Fibonacci.Impl.FeedbackMessage(goal_id=request.goal_id))
        tellings.publish(Fibonacci.Impl.FeedbackMessage(goal_id=request.goal_id))
        response.accepted = True
        return response

    node.create_service(Fibonacci.Impl.SendGoalService, "count/_action/send_goal", take)
    told: list[int] = []
    host: Any = SimpleNamespace(call=lambda handler, _with: told.append(handler))
    client = CompiledActionClient(host, HANDLERS, node, Fibonacci, "count")
    client.send(1, serialize(Fibonacci.Goal(order=3)))
    for _ in range(10):
        rclpy.spin_once(node, timeout_sec=0.1)
    assert told == [ANSWER, FEEDBACK, FEEDBACK]
    tellings.publish(Fibonacci.Impl.FeedbackMessage(goal_id=next(iter(client.goals.values())).goal_id))
    rclpy.spin_once(node, timeout_sec=0.1)
    assert told[3:] == [FEEDBACK]
