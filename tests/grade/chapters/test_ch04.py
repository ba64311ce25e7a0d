"""What the check of chapter 4's listener says of what is never joined, and of what is printed."""

import re

from coursekit.grade.exercise import find
from coursekit.grade.plan import Seen
from tests.grade.tried import verdict

STATUS, SPHERE = (f"s4_custom_interface/msg/{name}" for name in ("HardwareStatus", "Sphere"))


def mechanic(status=STATUS, topic="/py_hs_topic", output=""):
    ends = {topic: [{"node": "/py_subscriber_node", "type": status}], "/py_sphere_topic": [{"node": "/n", "type": SPHERE}]}
    return verdict("ch04.q2", Seen(outputs=[output], nodes=["/py_subscriber_node"], subscriptions=ends))


def test_a_subscription_of_another_name_or_type_is_told():
    assert mechanic(topic="/py_hs_topik").got == "subscriptions: /py_hs_topik, /py_sphere_topic"
    said = mechanic(status=SPHERE)
    assert said.got == f"type: {SPHERE}" and "never joined" in said.cause


def test_what_is_printed_is_told_to_be_so():
    line = re.sub("^a status is logged as: ", "", mechanic().expected)
    said = mechanic(output=f"{line}\n")
    assert said.cause.startswith("These are printed, not logged") and not said.hint


def test_a_status_in_other_words_gets_no_hint_about_subscriptions():
    said = mechanic(output="[INFO] [1.0] [py_subscriber_node]: 86 degrees, motors True\n")
    assert said.got == "86 degrees, motors True" and not said.hint


def test_where_nothing_is_logged_the_hint_is_about_subscriptions():
    assert mechanic(output="hello\n").hint == find("ch04.q2").hints[0]


def test_where_only_the_volume_is_wrong_the_hint_is_about_it():
    begin, lines = "[INFO] [1.0] [py_subscriber_node]: ", [""]
    while (said := mechanic(output="".join(lines))).expected.startswith("a status is logged as: "):
        lines.append(f"{begin}{said.expected.removeprefix('a status is logged as: ')}\n")
    assert said.hint == find("ch04.q2").hints[1]


def fetched(*brought_yet):
    feedback = "".join(f"Feedback:\n    brought_yet: {number}\n" for number in brought_yet)
    return verdict("ch04.q3", Seen(outputs=["", feedback])).cause


def test_feedback_that_is_wrong_is_explained():
    assert "Count the box first" in fetched(0)
    assert "half a second" in fetched()
    assert "counted in the loop" in fetched(0, 0, 0)
