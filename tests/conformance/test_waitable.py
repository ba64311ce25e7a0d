from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.guard_condition import GuardCondition
from rclpy.impl.implementation_singleton import rclpy_implementation as _rclpy
from rclpy.qos import QoSProfile
from rclpy.type_support import check_for_type_support
from rclpy.waitable import NumberOfEntities, Waitable
from test_msgs.msg import Empty as EmptyMsg
from test_msgs.srv import Empty as EmptySrv


class GuardWaitable(Waitable):
    """Waits for a guard condition of its own."""

    def __init__(self, node):
        super().__init__(MutuallyExclusiveCallbackGroup())
        self.node = node
        self.guard = GuardCondition(callback=None, callback_group=None, context=node.context)
        self.guard_index = None
        self.guard_is_ready = False
        self.executed = []

    def __enter__(self):
        self.guard.handle.__enter__()

    def __exit__(self, *error):
        self.guard.handle.__exit__(*error)

    def is_ready(self, wait_set):
        if wait_set.is_ready("guard_condition", self.guard_index):
            self.guard_is_ready = True
        return self.guard_is_ready

    def take_data(self):
        if self.guard_is_ready:
            self.guard_is_ready = False
            return "data"
        return None

    async def execute(self, taken_data):
        self.executed.append(taken_data)

    def get_num_entities(self):
        return NumberOfEntities(num_gcs=1)

    def add_to_wait_set(self, wait_set):
        self.guard_index = wait_set.add_guard_condition(self.guard.handle)


def test_a_waitable_is_executed_when_ready(world):
    node = world.node()
    waitable = GuardWaitable(node)
    node.add_waitable(waitable)
    assert waitable in list(node.waitables)
    world.spin_for(0.1)
    assert waitable.executed == []
    waitable.guard.trigger()
    world.spin_until(lambda: waitable.executed)
    assert waitable.executed == ["data"]


def test_a_removed_waitable_is_left_alone(world):
    node = world.node()
    waitable = GuardWaitable(node)
    node.add_waitable(waitable)
    node.remove_waitable(waitable)
    assert waitable not in list(node.waitables)
    waitable.guard.trigger()
    world.spin_for(0.1)
    assert waitable.executed == []


class HandleWaitable(Waitable):
    """Waits for one handle of rclpy's C module."""

    def __init__(self, kind, handle, take):
        super().__init__(MutuallyExclusiveCallbackGroup())
        self.kind, self.handle, self.take, self.taken = kind, handle, take, []

    def __enter__(self):
        self.handle.__enter__()

    def __exit__(self, *error):
        self.handle.__exit__(*error)

    def is_ready(self, wait_set):
        return wait_set.is_ready(self.kind, self.index)

    def take_data(self):
        return self.take()

    async def execute(self, taken_data):
        self.taken.append(taken_data)

    def get_num_entities(self):
        return NumberOfEntities(**{f"num_{self.kind}s".replace("subscriptions", "subs"): 1})

    def add_to_wait_set(self, wait_set):
        self.index = getattr(wait_set, f"add_{self.kind}")(self.handle)


def handle_of(node, kind, make):
    interface = EmptyMsg if kind == "subscription" else EmptySrv
    check_for_type_support(interface)
    with node.handle:
        return make(node.handle, interface, "thing", QoSProfile(depth=10).get_c_qos_profile())


def test_a_bare_subscription_can_be_waited_for(world):
    node = world.node(namespace="/deep")
    handle = handle_of(node, "subscription", _rclpy.Subscription)
    waitable = HandleWaitable("subscription", handle, lambda: handle.take_message(EmptyMsg, False)[0])
    node.add_waitable(waitable)
    publisher = node.create_publisher(EmptyMsg, "thing", 10)
    world.matched(publisher)
    publisher.publish(EmptyMsg())
    world.spin_until(lambda: waitable.taken)
    assert isinstance(waitable.taken[0], EmptyMsg)


def test_a_bare_service_can_be_waited_for(world):
    node = world.node(namespace="/deep")
    handle = handle_of(node, "service", _rclpy.Service)
    waitable = HandleWaitable("service", handle, lambda: handle.service_take_request(EmptySrv.Request)[0])
    node.add_waitable(waitable)
    client = node.create_client(EmptySrv, "thing")
    world.spin_until(client.service_is_ready)
    client.call_async(EmptySrv.Request())
    world.spin_until(lambda: waitable.taken)
    assert isinstance(waitable.taken[0], EmptySrv.Request)


def test_a_bare_client_can_be_waited_for(world):
    node = world.node(namespace="/deep")
    node.create_service(EmptySrv, "thing", lambda request, response: response)
    handle = handle_of(node, "client", _rclpy.Client)
    waitable = HandleWaitable("client", handle, lambda: handle.take_response(EmptySrv.Response)[1])
    node.add_waitable(waitable)
    world.spin_until(handle.service_server_is_available)
    handle.send_request(EmptySrv.Request())
    world.spin_until(lambda: waitable.taken)
    assert isinstance(waitable.taken[0], EmptySrv.Response)


def test_a_wait_set_waits_for_a_guard_condition(world):
    with world.context.handle:
        guard = _rclpy.GuardCondition(world.context.handle)
        wait_set = _rclpy.WaitSet(0, 1, 0, 0, 0, 0, world.context.handle)
    index = wait_set.add_guard_condition(guard)
    wait_set.wait(0)
    assert not wait_set.is_ready("guard_condition", index)
    wait_set.clear_entities()
    index = wait_set.add_guard_condition(guard)
    guard.trigger_guard_condition()
    wait_set.wait(10**9)
    assert wait_set.is_ready("guard_condition", index)


def test_entities_are_counted():
    total = NumberOfEntities(1, 2, 3, 4, 5, 6) + NumberOfEntities(1, 1, 1, 1, 1, 1)
    assert (total.num_subscriptions, total.num_guard_conditions, total.num_timers) == (2, 3, 4)
    assert (total.num_clients, total.num_services, total.num_events) == (5, 6, 7)
