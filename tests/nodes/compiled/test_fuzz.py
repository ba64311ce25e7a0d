"""Frames of any bytes, both ways: the session refuses what is wrong, and a program only throws."""

from __future__ import annotations

import random
import socket
import struct
import subprocess
from threading import Lock
from types import SimpleNamespace
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from rcl_interfaces.msg import ParameterEvent
from sensor_msgs.msg import PointCloud2, PointField

from coursekit.interfaces.cdr import serialize
from coursekit.nodes.compiled.channel import Channel
from coursekit.nodes.compiled.frames import packed
from coursekit.nodes.compiled.host import OPERATIONS, Host
from coursekit.nodes.compiled.workers import Workers
from coursekit.processes.session import Session
from tests.nodes.compiled.conftest import program

WAITING = {"sleep", "join", "block", "wait", "spin", "spin_once", "spin_some", "read", "thread", "ros_sleep"}
WAITING |= {"init", "shutdown", "wait_for_service", "wait_for_action", "tf_lookup", "tf_lookup_full", "tf_can"}
"""Operations that wait for others, or change more than the host."""
WORDS = st.one_of(
    st.integers(-3, 60).map(packed), st.integers(-(2**63), 2**63 - 1).map(packed), st.text(max_size=9).map(packed),
    st.binary(max_size=24), st.sampled_from(["std_msgs/msg/String", "std_srvs/srv/Trigger", "/x"]).map(packed),
)  # fmt: skip
QUESTION = st.tuples(
    st.sampled_from(["Q", "N"]),
    st.one_of(st.sampled_from(sorted(set(OPERATIONS) - WAITING)), st.text(max_size=5)),
    st.lists(WORDS, max_size=12).map(b"".join),
).map(lambda parts: parts[0].encode() + packed(parts[1]) + parts[2])
FRAME = st.one_of(QUESTION, st.binary(min_size=1, max_size=40).filter(lambda data: data[:1] not in (b"R", b"E")))


def stand_in(session: Session) -> Any:
    """A host without a child."""
    host = object.__new__(Host)
    host.session, host.clock, host.node_clocks, host.stopping = session, session.clock, [], False
    host.things, host.of_context, host.waiting = {}, {}, []
    host.process = SimpleNamespace(on_signal=[], handlers={}, env={})
    host.own_gids = set()
    host.output = SimpleNamespace(drain=lambda: None)  # type: ignore[assignment]
    host.blocked, host.threads, host.caught = {}, {}, set()
    host._lock, host._workers = Lock(), Workers(session.clock, lambda: pytest.fail("there is no child"))
    return host


def replies(data: bytes) -> list[bytes]:
    """The kinds of the frames that came down; each must be whole."""
    kinds = []
    while data:
        size = struct.unpack("<I", data[:4])[0]
        assert 25 <= size <= len(data) - 4
        kinds.append(data[4:5])
        data = data[4 + size :]
    return kinds


@settings(max_examples=150, deadline=None)
@given(frames=st.lists(FRAME, max_size=8), tail=st.binary(max_size=6))
def test_every_question_is_answered_or_refused(frames, tail):
    with (session := Session(virtual=False)).use():
        ours, theirs = socket.socketpair()
        with theirs:
            theirs.sendall(b"".join(struct.pack("<I", len(data)) + data for data in frames) + tail)
            theirs.shutdown(socket.SHUT_WR)
            Channel(stand_in(session), ours).serve()
            received = b""
            while part := theirs.recv(65_536):
                received += part
        kinds = replies(received)
        whole = [data for data in frames if data[:1] == b"Q"]
        assert kinds[0] == b"A" and len(kinds) - 1 <= len(whole)
        assert set(kinds[1:]) <= {b"A", b"X"}


def mutated(seed: int, count: int) -> bytes:
    """Messages and packed words with some bytes changed, cut or doubled, each after its length."""
    chance = random.Random(seed)
    cloud = PointCloud2(fields=[PointField(name="x", count=1)] * 3, data=b"1234567")
    seeds = [serialize(cloud), serialize(ParameterEvent(node="/n")), packed(3, "text", 7, "more"), b""]
    frames = []
    for _ in range(count):
        data = bytearray(chance.choice(seeds))
        for _ in range(chance.randrange(6)):
            if data:
                data[chance.randrange(len(data))] = chance.choice([0, 1, 127, 255, chance.randrange(256)])
        data = data[: chance.randrange(len(data) + 1)] if chance.random() < 0.3 else data
        frames.append(struct.pack("<I", len(data)) + bytes(data))
    return b"".join(frames)


@pytest.mark.parametrize("seed", [1, 2])
def test_a_program_only_throws_at_what_the_session_would_not_send(build, tmp_path, seed):
    (tmp_path / "frames.bin").write_bytes(mutated(seed, 3000))
    command = [build("frames", program("frames.cpp")), str(tmp_path / "frames.bin")]
    done = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)
    assert (done.returncode, done.stdout) == (0, "3000 1\n"), done.stderr
