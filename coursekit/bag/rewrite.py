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
    """Copy the messages of all inputs to every output that includes their topic."""
    writers = [BagWriter(output.settings) for output in outputs]
    targets: dict[str, list[BagWriter]] = {}
    try:
        for topic in {one.name: one for reader in inputs for one in reader.topics()}.values():
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
        waiting = [(message.stamp, number) for number, one in enumerate(inputs) if (message := one.peek()) is not None]
        if not waiting:
            return
        message = inputs[min(waiting)[1]].take()
        if message is not None:
            for writer in targets.get(message.topic, ()):
                writer.write(message)
