"""`ros2 bag convert`: rewrites bags as bags with other settings, with messages in order of time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from coursekit.bag.metadata import TopicMetadata
from coursekit.bag.reader import BagReader
from coursekit.bag.writer import BagWriter, WriteSettings


@dataclass
class Output:
    """One bag to write: its settings and its topics."""

    settings: WriteSettings
    wants: Callable[[TopicMetadata], bool] = field(default=lambda topic: True)


def rewrite(inputs: Sequence[BagReader], outputs: Sequence[Output]) -> None:
    """Copy the messages of all inputs to every output that includes their topic.

    >>> import tempfile
    >>> from coursekit.bag.storage import Message
    >>> from coursekit.bag.metadata import TopicMetadata
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     bag = BagWriter(WriteSettings(f"{folder}/all"))
    ...     for topic in ("/scan", "/image"):
    ...         bag.create_topic(TopicMetadata(topic, "std_msgs/msg/String"))
    ...         bag.write(Message(topic, b"data", 1))
    ...     bag.close()
    ...     source = BagReader(f"{folder}/all")
    ...     rewrite([source], [Output(WriteSettings(f"{folder}/some"), lambda topic: topic.name == "/scan")])
    ...     source.close()
    ...     smaller = BagReader(f"{folder}/some")
    ...     print([topic.name for topic in smaller.topics()])
    ...     smaller.close()
    ['/scan']
    """
    writers = [BagWriter(output.settings) for output in outputs]
    targets: dict[str, list[BagWriter]] = {}
    try:
        for topic in {recorded.name: recorded for reader in inputs for recorded in reader.topics()}.values():
            targets[topic.name] = [
                writer for writer, output in zip(writers, outputs, strict=True) if output.wants(topic)
            ]
            for writer in targets[topic.name]:
                writer.create_topic(topic)
        _copy(inputs, targets)
    finally:
        for writer in writers:
            writer.close()


def _copy(inputs: Sequence[BagReader], targets: dict[str, list[BagWriter]]) -> None:
    while True:
        waiting = [(message.stamp, number) for number, reader in enumerate(inputs) if (message := reader.peek()) is not None]
        if not waiting:
            return
        message = inputs[min(waiting)[1]].take()
        if message is not None:
            for writer in targets.get(message.topic, ()):
                writer.write(message)
