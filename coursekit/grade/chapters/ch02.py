"""Chapter 2: names, a listener, a relay, a node of one's own."""

from __future__ import annotations

from coursekit.grade.exercise import exercise
from coursekit.grade.trial import EVERY_NODE_S
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work

PACKAGE = "s2_py_pubsub"


@exercise(
    "ch02.q1",
    "Names in the graph",
    points=1,
    hints=(
        "Three cases: the name begins with `/`, with `~`, or with neither.",
        "The namespace `/` ends with the slash that you would add. `rstrip` takes it away.",
    ),
)
def full_name(work: Work) -> None:
    """Names expand as ROS expands them."""
    from coursekit.core.names import expand

    function = work.function("full_name")
    for name in ("scan", "/scan", "~/scan", "a/b", "~", "/a/b"):
        for namespace in ("/", "/vera", "/fleet/vera"):
            right, got = expand(name, "lidar", namespace), function(name, "lidar", namespace)
            if got != right:
                raise Wrong(
                    f"full_name({name!r}, 'lidar', {namespace!r}) that follows the rules of the table",
                    repr(got),
                    "With the namespace '/', is there one slash too many?" if "//" in str(got) else "",
                )


@exercise(
    "ch02.q2",
    "A listener",
    points=2,
    hints=(
        "Make the subscription in the constructor: self.create_subscription(String, 'py_str_topic', self.heard, 10).",
        "The callback is a method that takes the message; its text is msg.data.",
    ),
)
def listener(work: Work) -> None:
    """The node hears what is said and logs it."""
    work.built(PACKAGE)
    words = [f"word {number} of {id(work) % 97}" for number in range(3)]
    seen = work.try_out(
        f"run {PACKAGE} subscriber_exe",
        publish=[(0.5 + index, "/py_str_topic", "std_msgs/msg/String", {"data": word}) for index, word in enumerate(words)],
        seconds=4.0,
    )
    _expect_node(seen, "/py_subscriber_node")
    if not seen.subscriptions.get("/py_str_topic"):
        others = ", ".join(name for name, ends in seen.subscriptions.items() if ends) or "none"
        raise Wrong("a subscription to /py_str_topic", f"subscriptions: {others}", "Is the topic's name right?")
    for word in words:
        if f"I heard: {word}" not in seen.outputs[0]:
            raise Wrong(
                f"a log line with: I heard: {word}",
                seen.outputs[0].strip()[-300:] or "nothing was printed",
                "Does the callback log msg.data with self.get_logger().info(...)?",
                share=0.5,
            )


@exercise(
    "ch02.q3",
    "A relay",
    points=2,
    hints=(
        "The node has both: a publisher made in the constructor, and a subscription whose callback publishes.",
        "Texts in capitals: msg.data.upper().",
    ),
)
def relay(work: Work) -> None:
    """Each message comes out in capitals, once and at once."""
    work.built(PACKAGE)
    said = ["Vera is awake: 1", "grüß dich", "MiXed 7"]
    seen = work.try_out(
        f"run {PACKAGE} relay_exe",
        record=["/py_upper_topic"],
        publish=[
            (0.5 + index * 0.7, "/py_str_topic", "std_msgs/msg/String", {"data": one}) for index, one in enumerate(said)
        ],
        seconds=4.0,
    )
    _expect_node(seen, "/py_relay_node")
    if "/py_upper_topic" not in seen.messages:
        raise Wrong("a publisher on /py_upper_topic", f"topics: {', '.join(seen.topics)}", "Is the name right?")
    got = [message["data"] for _, message in seen.messages["/py_upper_topic"]]
    if [text.casefold() for text in got] != [text.casefold() for text in said]:
        raise Wrong(f"{len(said)} messages, one for each that came in", f"{len(got)}: {got!r:.200}", share=0.25)
    if any(text != text.upper() for text in got):
        raise Wrong("texts in capitals", f"{got!r:.200}", "str has a method for it.", share=0.5)
    late = [when - (0.5 + index * 0.7) for index, (when, _) in enumerate(seen.messages["/py_upper_topic"])]
    if max(late) > 0.2:
        raise Wrong("an answer at once", f"{max(late):.1f} s later", "Publish in the callback, not on a timer.", share=0.5)


@exercise(
    "ch02.q4",
    "Vera's health",
    points=2,
    hints=(
        "Two create_publisher lines with different types, one timer that publishes on both.",
        "std_msgs/msg has Float64, Int32, Bool, String and more: `%ros2 interface package std_msgs`.",
    ),
)
def health(work: Work) -> None:
    """Two topics of different types, 1 to 20 Hz, values that change."""
    work.built(PACKAGE)
    seen = work.try_out(f"run {PACKAGE} health_exe", record=["*"], seconds=4.0)
    own = {name: types[0] for name, types in seen.topics.items() if name not in EVERY_NODE_S and seen.publishers.get(name)}
    if len(set(own.values())) < 2:
        raise Wrong("at least two topics of different types", f"{own or 'none'}", "Was it built after the last change?")
    for name in own:
        messages = [message for _, message in seen.messages.get(name, [])]
        rate = len(messages) / 4.0
        if not 0.9 <= rate <= 21:
            raise Wrong(f"{name} between 1 and 20 times a second", f"{rate:.1f} times", share=0.5)
        if all(message == messages[0] for message in messages):
            raise Wrong(f"values on {name} that change", f"always {messages[0]}", share=0.5)


def _expect_node(seen: object, name: str) -> None:
    nodes = seen.nodes  # type: ignore[attr-defined]
    if name not in nodes:
        output = seen.outputs[0].strip().splitlines()  # type: ignore[attr-defined]
        raise Wrong(
            f"a node named {name}",
            f"nodes: {', '.join(nodes) or 'none'}" + (f"; the program said: {output[-1]}" if output else ""),
            "Does the executable start, and is the name in super().__init__ right?",
        )
