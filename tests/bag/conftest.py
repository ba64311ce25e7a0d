"""Bags made for tests."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from coursekit.bag.storage import Message
from coursekit.bag.writer import BagWriter, WriteSettings
from tests.bag.made import CHATTER, ODD, SECOND, text_bytes


@pytest.fixture
def make(tmp_path: Path) -> Callable[..., Path]:
    """make("talk", 10, storage_id="mcap", ...) writes so many messages, one a second, each third on /odd."""

    def write(name: str, count: int, **settings: object) -> Path:
        writer = BagWriter(WriteSettings(str(tmp_path / name), **settings))  # type: ignore[arg-type]
        for topic in (CHATTER, ODD):
            writer.create_topic(topic)
        for number in range(count):
            topic = ODD if number % 3 == 2 else CHATTER
            writer.write(Message(topic.name, text_bytes(f"Hello {number}"), (100 + number) * SECOND))
        writer.close()
        return tmp_path / name

    return write
