"""Frames cross as they were sent; what is malformed, too large or late is told, and nothing else happens."""

import json
import os
import socket
import struct
import threading

import pytest
from hypothesis import given
from hypothesis import strategies as st

from coursekit.joined.pipe import BODY, HEADER, Broken, Pipe, SocketPipe

JSON = st.recursive(st.none() | st.booleans() | st.integers() | st.text(), lambda inner: st.lists(inner, max_size=3))


@pytest.fixture
def ends():
    there, back = os.pipe(), os.pipe()
    yield Pipe(back[0], there[1]), Pipe(there[0], back[1]), there[1]
    for descriptor in (*there, *back):
        os.close(descriptor)


@given(st.dictionaries(st.text(), JSON, max_size=3), st.binary(max_size=2000))
def test_a_frame_arrives_as_it_was(header, body):
    there, back = os.pipe(), os.pipe()
    try:
        assert sent(Pipe(back[0], there[1]), Pipe(there[0], back[1]), header, body) == (header, body)
    finally:
        for descriptor in (*there, *back):
            os.close(descriptor)
    one, other = socket.socketpair()
    with one, other:
        assert sent(SocketPipe(one), SocketPipe(other), header, body) == (header, body)


def sent(ours, theirs, header, body):
    """What arrives; sent by a thread, for a pipe may have room for less."""
    sending = threading.Thread(target=ours.send, args=(header, body))
    sending.start()
    frame = theirs.receive()
    sending.join()
    return frame


@pytest.mark.parametrize(
    "data",
    [
        struct.pack("<II", HEADER + 1, 0),
        struct.pack("<II", 2, BODY + 1),
        struct.pack("<II", 2, 0) + b"[]",
        struct.pack("<II", 3, 0) + b"\xff\xfe\xfd",
        struct.pack("<II", 60_000, 0) + b"[" * 60_000,
    ],
    ids=["long header", "long body", "no object", "no text", "nested"],
)
def test_a_malformed_frame_is_told(ends, data):
    _, theirs, raw = ends
    sending = threading.Thread(target=os.write, args=(raw, data))
    sending.start()
    with pytest.raises(Broken, match="more than it may|malformed"):
        theirs.receive(5.0)
    sending.join()


def test_silence_and_the_other_s_end_are_told(ends):
    ours, theirs, raw = ends
    with pytest.raises(Broken, match="did not answer in time"):
        theirs.receive(0.0)
    os.write(raw, struct.pack("<II", 10, 0) + json.dumps("half")[:3].encode())
    with pytest.raises(Broken, match="did not answer in time"):
        theirs.receive(0.0)
    del ours
