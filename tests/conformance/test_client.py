import threading
import time

import pytest
import rclpy
from rclpy.exceptions import InvalidHandle
from std_srvs.srv import SetBool, Trigger


def answer(request, response):
    response.success = True
    return response


def test_an_absent_service_is_not_waited_for_when_told_so(world):
    client = world.node().create_client(Trigger, "absent")
    before = time.monotonic()
    assert not client.wait_for_service(timeout_sec=0)
    assert time.monotonic() - before < 1.0
    assert not client.service_is_ready()


def test_waiting_for_an_absent_service_takes_the_time_given(world):
    client = world.node().create_client(Trigger, "absent")
    before = time.monotonic()
    assert not client.wait_for_service(timeout_sec=0.5)
    assert 0.4 < time.monotonic() - before < 1.5


def test_a_service_that_comes_later_is_found(world):
    node = world.node()
    client = node.create_client(Trigger, "late")
    timer = threading.Timer(0.2, lambda: node.create_service(Trigger, "late", answer))
    timer.start()
    assert client.wait_for_service(timeout_sec=5.0)
    timer.join()


@pytest.mark.parametrize("request_", [None, 1, "text", SetBool.Request(), Trigger.Response()])
def test_another_type_is_no_request(world, request_):
    client = world.node().create_client(Trigger, "go")
    with pytest.raises(TypeError):
        client.call_async(request_)
    with pytest.raises(TypeError):
        client.call(request_)


def test_call_waits_for_the_response(world):
    node = world.node()
    node.create_service(Trigger, "go", answer)
    client = node.create_client(Trigger, "go")
    assert client.wait_for_service(timeout_sec=5.0)
    answers = []
    thread = threading.Thread(target=lambda: answers.append(client.call(Trigger.Request())), daemon=True)
    thread.start()
    world.spin_until(lambda: answers)
    thread.join(timeout=5)
    assert answers[0].success


def test_a_request_with_no_server_stays_open(world):
    client = world.node().create_client(Trigger, "absent")
    future = client.call_async(Trigger.Request())
    world.spin_for(0.1)
    assert not future.done()


def test_a_removed_request_is_not_answered(world):
    node = world.node()
    node.create_service(Trigger, "go", answer)
    client = node.create_client(Trigger, "go")
    client.wait_for_service(timeout_sec=5.0)
    future = client.call_async(Trigger.Request())
    client.remove_pending_request(future)
    other = client.call_async(Trigger.Request())
    assert world.result(other).success
    assert not future.done()


def test_a_cancelled_request_stays_cancelled(world):
    node = world.node()
    node.create_service(Trigger, "go", answer)
    client = node.create_client(Trigger, "go")
    client.wait_for_service(timeout_sec=5.0)
    future = client.call_async(Trigger.Request())
    future.cancel()
    world.spin_for(0.1)
    assert future.cancelled()


def test_done_callbacks_get_the_future(world):
    node, seen = world.node(), []
    node.create_service(Trigger, "go", answer)
    client = node.create_client(Trigger, "go")
    client.wait_for_service(timeout_sec=5.0)
    future = client.call_async(Trigger.Request())
    future.add_done_callback(seen.append)
    world.result(future)
    world.spin_until(lambda: seen)
    assert seen == [future]


def test_a_coroutine_may_await_a_call(world):
    node, seen = world.node(), []
    node.create_service(Trigger, "go", answer)
    client = node.create_client(Trigger, "go")
    client.wait_for_service(timeout_sec=5.0)

    async def ask():
        response = await client.call_async(Trigger.Request())
        seen.append(response.success)

    world.executor.create_task(ask)
    world.spin_until(lambda: seen)
    assert seen == [True]


def test_a_destroyed_client_is_refused(world):
    node = world.node()
    client = node.create_client(Trigger, "go")
    assert client in list(node.clients)
    assert node.destroy_client(client)
    assert not node.destroy_client(client)
    with pytest.raises(InvalidHandle):
        client.service_is_ready()


def test_spin_until_future_complete_is_the_usual_way(world):
    node = world.node(spin=False)
    node.create_service(Trigger, "go", answer)
    client = node.create_client(Trigger, "go")
    client.wait_for_service(timeout_sec=5.0)
    future = client.call_async(Trigger.Request())
    rclpy.spin_until_future_complete(node, future, executor=world.executor, timeout_sec=5.0)
    assert future.result().success
