from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.guard_condition import GuardCondition
from rclpy.waitable import NumberOfEntities, Waitable


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


def test_entities_are_counted():
    total = NumberOfEntities(1, 2, 3, 4, 5, 6) + NumberOfEntities(1, 1, 1, 1, 1, 1)
    assert (total.num_subscriptions, total.num_guard_conditions, total.num_timers) == (2, 3, 4)
    assert (total.num_clients, total.num_services, total.num_events) == (5, 6, 7)
