import pytest
from lifecycle_msgs.msg import State, Transition, TransitionEvent
from lifecycle_msgs.srv import ChangeState, GetAvailableStates, GetAvailableTransitions, GetState
from rclpy.lifecycle import (
    LifecycleNode,
    TransitionCallbackReturn,
)

SUCCESS, FAILURE, ERROR = (
    TransitionCallbackReturn.SUCCESS,
    TransitionCallbackReturn.FAILURE,
    TransitionCallbackReturn.ERROR,
)


class Scripted(LifecycleNode):
    """A node whose callbacks answer as told, and are written down."""

    def __init__(self, name, answers=None, **kwargs):
        super().__init__(name, **kwargs)
        self.answers, self.calls = answers or {}, []

    def _answer(self, callback, state):
        self.calls.append((callback, state.label))
        answer = self.answers.get(callback, SUCCESS)
        if isinstance(answer, Exception):
            raise answer
        return answer

    def on_configure(self, state):
        return self._answer("configure", state)

    def on_cleanup(self, state):
        return self._answer("cleanup", state)

    def on_activate(self, state):
        return self._answer("activate", state)

    def on_deactivate(self, state):
        return self._answer("deactivate", state)

    def on_shutdown(self, state):
        return self._answer("shutdown", state)

    def on_error(self, state):
        return self._answer("error", state)


class Managed:
    """A managed node, and a node that asks it."""

    def __init__(self, world, answers=None):
        self.world = world
        self.node = world.node("lc", node_class=Scripted, answers=answers)
        self.asker = world.node("asker")

    def ask(self, kind, name, **fields):
        client = self.asker.create_client(kind, f"/lc/{name}")
        assert client.wait_for_service(timeout_sec=8.0)
        return self.world.result(client.call_async(kind.Request(**fields)))

    def change(self, number=0, label=""):
        return self.ask(ChangeState, "change_state", transition=Transition(id=number, label=label)).success

    @property
    def state(self):
        state = self.ask(GetState, "get_state").current_state
        return state.id, state.label


@pytest.fixture
def managed(world):
    return lambda answers=None: Managed(world, answers)


def scripted(world, answers=None):
    return world.node("lc", node_class=Scripted, answers=answers, spin=False)


def state_of(node):
    return node._state_machine.current_state[1]


def test_a_node_starts_unconfigured(managed):
    assert managed().state == (State.PRIMARY_STATE_UNCONFIGURED, "unconfigured")


def test_the_whole_life(managed):
    managed_node, states = managed(), []
    for number in (1, 3, 4, 2, 5):
        assert managed_node.change(number)
        states.append(managed_node.state[1])
    assert states == ["inactive", "active", "inactive", "unconfigured", "finalized"]
    assert [call for call, _ in managed_node.node.calls] == [
        "configure",
        "activate",
        "deactivate",
        "cleanup",
        "shutdown",
    ]
    assert [state for _, state in managed_node.node.calls] == [
        "unconfigured",
        "inactive",
        "active",
        "inactive",
        "unconfigured",
    ]


def test_a_callback_that_forgets_its_return_ends_the_program(world):
    node = scripted(world, answers={"configure": None})
    with pytest.raises(AttributeError, match="'NoneType' object has no attribute 'to_label'"):
        node.trigger_configure()
    assert [call for call, _ in node.calls] == ["configure"]
    assert state_of(node) == "configuring"


def test_labels_work_as_well(managed):
    managed_node = managed()
    assert managed_node.change(label="configure")
    assert managed_node.change(label="activate")
    assert managed_node.state == (3, "active")


@pytest.mark.parametrize(("number", "label"), [(3, ""), (99, ""), (0, "nonsense"), (4, ""), (2, "")])
def test_what_is_not_possible_changes_nothing(managed, number, label):
    managed_node = managed()
    assert not managed_node.change(number, label)
    assert managed_node.state[1] == "unconfigured"


def transitions(response):
    return {each.transition.label for each in response.available_transitions}


@pytest.mark.parametrize(
    ("path", "available"),
    [
        ([], {"configure", "shutdown"}),
        ([1], {"activate", "cleanup", "shutdown"}),
        ([1, 3], {"deactivate", "shutdown"}),
        ([5], set()),
    ],
)
def test_available_transitions(managed, path, available):
    managed_node = managed()
    for number in path:
        assert managed_node.change(number)
    assert transitions(managed_node.ask(GetAvailableTransitions, "get_available_transitions")) == available


def test_all_states_are_listed(managed):
    states = managed().ask(GetAvailableStates, "get_available_states").available_states
    assert [(each.id, each.label) for each in states] == [
        (0, "unknown"),
        (1, "unconfigured"),
        (2, "inactive"),
        (3, "active"),
        (4, "finalized"),
        (10, "configuring"),
        (11, "cleaningup"),
        (12, "shuttingdown"),
        (13, "activating"),
        (14, "deactivating"),
        (15, "errorprocessing"),
    ]


def test_the_graph_is_told(managed):
    graph = managed().ask(GetAvailableTransitions, "get_transition_graph")
    assert len(graph.available_transitions) == 25
    assert transitions(graph) == {
        "configure",
        "cleanup",
        "activate",
        "deactivate",
        "shutdown",
        "transition_success",
        "transition_failure",
        "transition_error",
    }


def test_changes_are_published(managed):
    managed_node, events = managed(), []
    managed_node.asker.create_subscription(
        TransitionEvent,
        "/lc/transition_event",
        lambda event: events.append((event.start_state.label, event.goal_state.label)),
        10,
    )
    managed_node.world.spin_until(lambda: managed_node.asker.count_publishers("/lc/transition_event") >= 1)
    managed_node.world.spin_for(0.3)
    assert managed_node.change(1)
    managed_node.world.spin_until(lambda: len(events) == 2)
    assert events == [("unconfigured", "configuring"), ("configuring", "inactive")]


@pytest.mark.parametrize(
    ("answers", "answer", "state"),
    [
        ({}, SUCCESS, "inactive"),
        ({"configure": FAILURE}, FAILURE, "unconfigured"),
        ({"configure": ERROR, "error": SUCCESS}, ERROR, "unconfigured"),
        ({"configure": ERROR, "error": FAILURE}, ERROR, "finalized"),
        ({"configure": ERROR, "error": ERROR}, ERROR, "finalized"),
        ({"configure": ValueError("broken"), "error": SUCCESS}, ERROR, "unconfigured"),
        ({"configure": ERROR, "error": ValueError("worse")}, ERROR, "finalized"),
    ],
)
def test_the_callback_says_where_it_ends(world, answers, answer, state):
    node = scripted(world, answers)
    assert node.trigger_configure() == answer
    assert state_of(node) == state


@pytest.mark.parametrize(
    ("answers", "path", "state"),
    [
        ({"activate": FAILURE}, ["configure", "activate"], "inactive"),
        ({"deactivate": FAILURE}, ["configure", "activate", "deactivate"], "active"),
        ({"cleanup": FAILURE}, ["configure", "cleanup"], "inactive"),
        ({"shutdown": FAILURE}, ["shutdown"], "finalized"),
        ({"shutdown": ERROR, "error": SUCCESS}, ["configure", "shutdown"], "unconfigured"),
    ],
)
def test_failures_lead_back(world, answers, path, state):
    node = scripted(world, answers)
    for step in path:
        getattr(node, f"trigger_{step}")()
    assert state_of(node) == state


def test_an_impossible_trigger_is_an_error(world, capfd):
    """Humble raises; later releases tell by what they return. Programs look for rcl's words in the error."""
    node = scripted(world)
    try:
        assert node.trigger_activate() == ERROR
    except RuntimeError as error:
        words = "Failed to trigger lifecycle state machine transition: Transition is not registered., at ."
        assert str(error).startswith(words)
        assert str(error).endswith("(known: configure [1], shutdown [5])")
    assert state_of(node) == "unconfigured"
    assert "[rcl_lifecycle]: No transition matching 3 found for current state unconfigured\n" in capfd.readouterr().err


def test_a_finalized_node_does_not_shut_down(world):
    node = scripted(world)
    node.trigger_shutdown()
    with pytest.raises(RuntimeError):
        node.trigger_shutdown()


def test_the_services_can_be_declined(world):
    node = world.node("quiet", node_class=LifecycleNode, enable_communication_interface=False)
    services = [name for name, _ in node.get_service_names_and_types_by_node("quiet", "/")]
    assert "/quiet/change_state" not in services
    assert node.trigger_configure() == SUCCESS


def test_services_are_made_only_when_wanted(world):
    silent = world.node("silent", node_class=LifecycleNode, enable_communication_interface=False)
    assert not hasattr(silent, "_service_change_state")
    assert not silent._state_machine.service_change_state
    spoken = world.node("spoken", node_class=LifecycleNode)
    assert spoken._state_machine.service_get_state
    with pytest.raises(TypeError):
        world.node("neither", node_class=LifecycleNode, enable_communication_interface="asd")
