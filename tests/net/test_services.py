"""Services, parameters, actions, tf and lifecycle between two sides, with rclpy's own classes."""

import contextlib
import threading

import pytest
import rclpy
from example_interfaces.srv import AddTwoInts
from geometry_msgs.msg import TransformStamped
from rclpy.action import ActionClient, ActionServer
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from rclpy.node import Node
from test_msgs.action import Fibonacci
from tf2_ros import Buffer, StaticTransformBroadcaster, TransformListener

from coursekit.core.qos import Qos
from coursekit.core.service import RequestId
from coursekit.net.joining import join
from coursekit.net.zenoh_session import open_router
from coursekit.processes.session import Session

from .sides import LIMIT, Inbox, free_port


def server(side, name="server"):
    return side.graph.add_node(name, "/").server("/add", AddTwoInts, Qos())


def client(side, name="client"):
    return side.graph.add_node(name, "/").client("/add", AddTwoInts, Qos())


def answer(inbox):
    """Add, as a server's callback does."""
    request, request_id = inbox.take()
    inbox.source.respond(request_id, AddTwoInts.Response(sum=request.a + request.b))
    return request_id


def test_a_request_is_answered_across_the_network(side):
    one, two = side(), side()
    there, asked = Inbox(server(one)), client(two)
    two.until(asked.server_is_ready)
    got = Inbox(asked)
    number = asked.send(AddTwoInts.Request(a=2, b=3))
    answer(there)
    assert [(at, response.sum) for at, response in [got.take()]] == [(number, 5)]


def test_two_clients_with_the_same_numbers_get_their_own_answers(side):
    one, two = side(), side()
    there, first, second = Inbox(server(one)), client(two, "first"), client(two, "second")
    two.until(first.server_is_ready)
    gots = [Inbox(first), Inbox(second)]
    for number, one_of_them in enumerate((first, second)):
        assert one_of_them.send(AddTwoInts.Request(a=number, b=10)) == 1
    waiting = [there.take(), there.take()]
    gids = set()
    for request, request_id in reversed(waiting):
        gids.add(request_id.client._came_with.gid)
        there.source.respond(request_id, AddTwoInts.Response(sum=request.a + request.b))
    assert [got.take()[1].sum for got in gots] == [10, 11] and len(gids) == 2


def test_each_of_two_servers_of_a_name_is_asked_once(side):
    one, two, three = side(), side(), side()
    servers = [Inbox(server(one)), Inbox(server(two))]
    asked = client(three)
    three.until(lambda: len(three.graph.servers_of(asked)) == 2)
    got = Inbox(asked)
    asked.send(AddTwoInts.Request(a=1, b=1))
    for there in servers:
        answer(there)
    assert got.take()[1].sum == 2 and got.take()[1].sum == 2
    assert all(there.source.take() is None for there in servers)


def test_a_request_of_bytes_that_are_none_is_told_and_the_next_is_answered(side):
    one, two = side(), side()
    there, asked = Inbox(server(one)), client(two)
    two.until(asked.server_is_ready)
    key = "0/add/example_interfaces::srv::dds_::AddTwoInts_/TypeHashNotSupported"
    from coursekit.net.wire.attachment import Attachment

    list(two.link.place.session.get(key, payload=b"junk", attachment=Attachment(1, 1, bytes(16)).data()))
    list(two.link.place.session.get(key, payload=b"junk"))
    one.until_told("A request to /add cannot be read")
    got = Inbox(asked)
    asked.send(AddTwoInts.Request(a=4, b=4))
    answer(there)
    assert got.take()[1].sum == 8


def test_who_only_listens_asks_nobody_and_is_told(side):
    one, two = side(), side(listen_only=True)
    there, asked = server(one), client(two)
    two.until(asked.server_is_ready)
    asked.send(AddTwoInts.Request())
    two.until_told("You only listen: the request to /add is not sent")
    assert there.take() is None


def test_an_answer_for_a_client_that_is_gone_does_no_harm(side):
    one, two = side(), side()
    there, asked = Inbox(server(one)), client(two)
    two.until(asked.server_is_ready)
    asked.send(AddTwoInts.Request())
    _, request_id = there.take()
    assert isinstance(request_id, RequestId)
    two.link.close()
    one.until(lambda: one.names() == ["/server"])
    there.source.respond(request_id, AddTwoInts.Response())
    one.link.settle()


class Robot:
    """A session with nodes of rclpy, spun by a thread of its own."""

    def __init__(self, address):
        self.session = Session()
        self.context = rclpy.Context()
        self.nodes = []
        self.address = address
        self.end = threading.Event()

    @contextlib.contextmanager
    def use(self):
        from coursekit.processes import current_session

        before, current_session.session = current_session.session, self.session
        try:
            yield self
        finally:
            current_session.session = before

    def start(self, *makers):
        with self.use():
            rclpy.init(context=self.context)
            self.executor = MultiThreadedExecutor(context=self.context)
            self.link = join(self.session, 0, self.address)
            self.nodes = [make(self.context) for make in makers]
            for node in self.nodes:
                self.executor.add_node(node)
        self.thread = threading.Thread(target=self.spin, daemon=True)
        self.thread.start()
        return self.nodes

    def spin(self):
        with contextlib.suppress(ExternalShutdownException):
            self.executor.spin()

    def close(self):
        with self.use():
            rclpy.shutdown(context=self.context)
            self.thread.join(LIMIT)
            self.session.close()


@pytest.fixture
def pair():
    address = f"tcp/127.0.0.1:{free_port()}"
    router = open_router([address])
    robots = [Robot(address), Robot(address)]
    yield robots
    for robot in robots:
        robot.close()
    router.close()


def result(future):
    done = threading.Event()
    future.add_done_callback(lambda _: done.set())
    assert done.wait(LIMIT)
    return future.result()


def test_an_action_with_feedback_and_a_parameter(pair):
    def act(goal):
        feedback = Fibonacci.Feedback()
        for order in range(2, goal.request.order):
            feedback.sequence = [*feedback.sequence, order]
            goal.publish_feedback(feedback)
        goal.succeed()
        return Fibonacci.Result(sequence=feedback.sequence)

    (robot,) = pair[0].start(lambda context: Node("robot", context=context))
    robot.declare_parameter("speed", 1.5)
    ActionServer(robot, Fibonacci, "/fibonacci", act)
    (mine,) = pair[1].start(lambda context: Node("mine", context=context))
    client = ActionClient(mine, Fibonacci, "/fibonacci")
    assert client.wait_for_server(LIMIT)
    heard = []
    goal = result(client.send_goal_async(Fibonacci.Goal(order=6), feedback_callback=lambda one: heard.append(one)))
    assert goal.accepted
    answer = result(goal.get_result_async())
    assert list(answer.result.sequence) == [2, 3, 4, 5] and answer.status == 4
    from rcl_interfaces.srv import GetParameters

    parameters = mine.create_client(GetParameters, "/robot/get_parameters")
    assert parameters.wait_for_service(LIMIT)
    assert result(parameters.call_async(GetParameters.Request(names=["speed"]))).values[0].double_value == 1.5


def test_frames_and_a_managed_node(pair):
    class Managed(LifecycleNode):
        def on_configure(self, state):
            return TransitionCallbackReturn.SUCCESS

    (robot,) = pair[0].start(lambda context: Managed("managed", context=context))
    frame = TransformStamped()
    frame.header.frame_id, frame.child_frame_id = "base_link", "laser"
    frame.transform.translation.x = 0.25
    StaticTransformBroadcaster(robot).sendTransform(frame)
    (mine,) = pair[1].start(lambda context: Node("mine", context=context))
    buffer = Buffer(node=None)
    arrived = threading.Event()
    add = buffer.set_transform_static
    buffer.set_transform_static = lambda *args: (add(*args), arrived.set())
    listener = TransformListener(buffer, mine)
    assert arrived.wait(LIMIT)
    transform = buffer.lookup_transform("base_link", "laser", rclpy.time.Time())
    assert transform.transform.translation.x == 0.25
    from lifecycle_msgs.srv import ChangeState, GetState

    change = mine.create_client(ChangeState, "/managed/change_state")
    assert change.wait_for_service(LIMIT)
    request = ChangeState.Request()
    request.transition.id = 1
    assert result(change.call_async(request)).success
    state = mine.create_client(GetState, "/managed/get_state")
    assert state.wait_for_service(LIMIT)
    assert result(state.call_async(GetState.Request())).current_state.label == "inactive"
    del listener


def test_a_program_ends_by_itself_though_a_server_there_never_answers(side, session):
    far = side()
    far.graph.add_node("silent", "/").server("/add_two_ints", AddTwoInts, Qos())

    def ask():
        import rclpy

        rclpy.init()
        node = rclpy.create_node("client")
        client = node.create_client(AddTwoInts, "add_two_ints")
        assert client.wait_for_service(LIMIT)
        client.call_async(AddTwoInts.Request(a=1, b=2))
        rclpy.shutdown()

    with session.use():
        join(session, 0, side.address)
        assert session.start(ask, name="client").wait(LIMIT) == 0
