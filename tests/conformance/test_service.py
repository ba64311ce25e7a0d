import pytest
from rclpy.exceptions import InvalidHandle, InvalidServiceNameException
from std_msgs.msg import String
from std_srvs.srv import SetBool, Trigger


def echo(request, response):
    response.success = request.data
    response.message = "on" if request.data else "off"
    return response


def test_a_request_gets_its_response(world):
    node = world.node()
    node.create_service(SetBool, "switch", echo)
    client = node.create_client(SetBool, "switch")
    assert client.wait_for_service(timeout_sec=5.0)
    response = world.result(client.call_async(SetBool.Request(data=True)))
    assert response == SetBool.Response(success=True, message="on")


def test_both_ends_name_the_logger_of_their_node(world):
    node = world.node("ends", namespace="/of/parts")
    service = node.create_service(Trigger, "switch", echo)
    client = node.create_client(Trigger, "switch")
    assert (service.logger_name, client.logger_name) == ("of.parts.ends", "of.parts.ends")


def test_every_request_gets_its_own_response(world):
    node = world.node()
    node.create_service(SetBool, "switch", echo)
    client = node.create_client(SetBool, "switch")
    client.wait_for_service(timeout_sec=5.0)
    futures = [client.call_async(SetBool.Request(data=bool(i % 2))) for i in range(6)]
    assert [world.result(future).success for future in futures] == [False, True] * 3


def test_each_client_gets_its_own_response(world):
    server, one, two = world.node("server"), world.node("one"), world.node("two")
    server.create_service(SetBool, "switch", echo)
    clients = [one.create_client(SetBool, "switch"), two.create_client(SetBool, "switch")]
    for client in clients:
        assert client.wait_for_service(timeout_sec=5.0)
    futures = [client.call_async(SetBool.Request(data=i == 0)) for i, client in enumerate(clients)]
    assert [world.result(future).success for future in futures] == [True, False]


def test_a_coroutine_may_answer(world):
    node = world.node()

    async def later(request, response):
        response.message = "later"
        return response

    node.create_service(Trigger, "later", later)
    client = node.create_client(Trigger, "later")
    client.wait_for_service(timeout_sec=5.0)
    assert world.result(client.call_async(Trigger.Request())).message == "later"


@pytest.mark.parametrize("answer", [None, 1, String()])
def test_a_wrong_answer_raises_out_of_the_servers_spin(world, answer):
    node = world.node()
    node.create_service(Trigger, "wrong", lambda request, response: answer)
    client = node.create_client(Trigger, "wrong")
    client.wait_for_service(timeout_sec=5.0)
    client.call_async(Trigger.Request())
    with pytest.raises(TypeError):
        world.spin_for(3.0)


def test_the_name_is_resolved(world):
    node = world.node("n", namespace="/ns")
    assert node.create_service(Trigger, "~/go", echo).service_name == "/ns/n/go"
    assert node.create_service(Trigger, "go", echo).service_name == "/ns/go"


@pytest.mark.parametrize("name", ["a b", "go/", "1go", "go?"])
def test_a_bad_service_name_is_refused(world, name):
    with pytest.raises(InvalidServiceNameException):
        world.node().create_service(Trigger, name, echo)


def test_a_message_is_no_service(world):
    with pytest.raises(RuntimeError, match="The service type provided is not valid"):
        world.node().create_service(String, "go", echo)


def test_a_destroyed_service_is_gone(world):
    node = world.node()
    service = node.create_service(Trigger, "go", echo)
    client = node.create_client(Trigger, "go")
    assert client.wait_for_service(timeout_sec=5.0)
    assert node.destroy_service(service)
    assert not node.destroy_service(service)
    world.spin_until(lambda: not client.service_is_ready())
    with pytest.raises(InvalidHandle):
        service.service_name  # noqa: B018


def test_services_are_listed(world):
    node = world.node()
    service = node.create_service(Trigger, "go", echo)
    assert service in list(node.services)


def test_the_request_and_response_have_their_types(world):
    node, seen = world.node(), []

    def look(request, response):
        seen.append((type(request), type(response)))
        return response

    node.create_service(Trigger, "look", look)
    client = node.create_client(Trigger, "look")
    client.wait_for_service(timeout_sec=5.0)
    world.result(client.call_async(Trigger.Request()))
    assert seen == [(Trigger.Request, Trigger.Response)]


def test_a_request_can_be_taken_by_hand(world):
    node = world.node()
    service = node.create_service(SetBool, "switch", echo)
    client = node.create_client(SetBool, "switch")
    world.spin_until(client.service_is_ready)
    node.executor.remove_node(node)
    client.call_async(SetBool.Request(data=True))
    taken = (None, None)
    while taken == (None, None):
        with service.handle:
            taken = service.handle.service_take_request(SetBool.Request)
    request, header = taken
    assert request.data and header.source_timestamp > 0
