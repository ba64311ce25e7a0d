"""What the checks of chapter 3 say of services that do not answer, and of switches that show nothing."""

from coursekit.grade.plan import Seen
from tests.grade.tried import verdict

SET = "std_srvs/srv/SetBool"


def gate(services, beside):
    own = {name: ["example_interfaces/srv/AddTwoInts"] for name in services}
    return Seen(outputs=[""], nodes=["/py_gate_node"], services=own, responses=[None] * 3, beside=[beside])


def test_a_gate_of_another_name_is_told_by_its_name():
    said = verdict("ch03.q3", gate(["/py_gate_servic", "/py_gate_node/get_parameters"], ""))
    assert (said.expected, said.got) == ("a service /py_gate_service", "services: /py_gate_servic")


def test_a_gate_that_does_not_ask_is_no_deadlock():
    assert verdict("ch03.q3", gate(["/py_gate_service"], "")).cause.startswith("The server was not asked")
    assert verdict("ch03.q3", gate(["/py_gate_service"], "asked for 1 and 2")).cause.startswith("A deadlock?")


def lamp(*messages):
    """A switch whose topic says these, at these seconds."""
    answers = [{"success": True, "message": "done"}] * 2
    told = [(when, {"data": on}) for when, on in messages]
    seen = Seen(outputs=[""], services={"/switch": [SET]}, topics={"/lamp": ["std_msgs/msg/Bool"]})
    seen.publishers, seen.responses, seen.messages = {"/lamp": [{"node": "/lamp"}]}, answers, {"/lamp": told}
    return verdict("ch03.q4", seen, seen)


def test_of_a_lamp_that_tells_changes_only_the_timer_is_asked():
    said = lamp((3.05, True), (6.05, False))
    assert said.got == "2 messages on /lamp in 9 s" and "timer" in said.cause


def test_of_a_lamp_that_stays_off_the_callback_is_asked():
    said = lamp(*((at / 2, False) for at in range(18)))
    assert said.got.startswith("no difference on /lamp") and "self" in said.cause


def test_a_lamp_that_shows_it_is_right():
    assert lamp(*((at / 2, 3 < at / 2 < 6.1) for at in range(18))).passed
