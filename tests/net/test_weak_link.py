"""The weak link carries what it is given: later, slower, or only when it is mended."""

import contextlib
import socket
import threading
import time

import pytest
from std_msgs.msg import Empty, UInt8MultiArray

from coursekit.core.qos import BEST_EFFORT, KEEP_ALL, RELIABLE, Qos
from coursekit.net.address import host_and_port
from coursekit.net.errors import NoNetwork
from coursekit.net.weak_link import WeakLink

from .sides import LIMIT, Inbox, Side, free_port, network


@pytest.fixture
def echo():
    """The address of a server that says everything back."""
    listener = socket.create_server(("127.0.0.1", 0))

    def serve():
        with contextlib.suppress(OSError):
            while True:
                connection, _ = listener.accept()
                threading.Thread(target=answer, args=(connection,), daemon=True).start()

    def answer(one):
        with one, contextlib.suppress(OSError):
            while data := one.recv(65536):
                one.sendall(data)

    threading.Thread(target=serve, daemon=True).start()
    yield f"tcp/127.0.0.1:{listener.getsockname()[1]}"
    listener.close()


@pytest.fixture
def link(echo):
    weak_link = WeakLink(echo)
    yield weak_link
    weak_link.close()


def dial(link):
    return socket.create_connection(host_and_port(link.address), timeout=LIMIT)


def say(one, data):
    one.sendall(data)
    heard = b""
    while len(heard) < len(data):
        heard += one.recv(65536)
    return heard


def test_it_carries_everything_both_ways(link):
    data = bytes(range(256)) * 4000
    with dial(link) as one, dial(link) as two:
        threading.Thread(target=one.sendall, args=(data,), daemon=True).start()
        assert say(two, b"beside") == b"beside"
        heard = b""
        while len(heard) < len(data):
            heard += one.recv(65536)
    assert heard == data


@pytest.mark.parametrize(("make", "least"), [(lambda one: one.late(0.1), 0.2), (lambda one: one.slow(100_000), 0.2)])
def test_what_is_late_or_slow_takes_at_least_its_time(link, make, least):
    make(link)
    with dial(link) as connection:
        begin = time.monotonic()
        assert say(connection, bytes(20_000)) == bytes(20_000)
        assert time.monotonic() - begin >= least


def test_while_it_is_cut_nothing_arrives_and_nobody_gets_in(link):
    with dial(link) as connection:
        assert say(connection, b"before") == b"before"
        link.cut()
        link.cut()
        with pytest.raises(ConnectionRefusedError):
            dial(link)
        connection.sendall(b"on the way")
        connection.settimeout(0.2)
        with pytest.raises(TimeoutError):
            connection.recv(100)
        connection.settimeout(LIMIT)
        link.mend()
        assert connection.recv(100) == b"on the way"
        with dial(link) as two:
            assert say(two, b"again") == b"again"


def test_who_hangs_up_is_told_to_the_other_end(link):
    with dial(link) as connection:
        say(connection, b"hello")
        connection.shutdown(socket.SHUT_WR)
        assert connection.recv(100) == b""


def test_it_ends_and_where_nobody_listens_it_hangs_up():
    link = WeakLink(f"127.0.0.1:{free_port()}")
    with dial(link) as connection:
        assert connection.recv(100) == b""
    link.close()
    link.close()
    with pytest.raises(ConnectionRefusedError):
        dial(link)


def test_it_listens_on_loopback_only_and_an_address_that_is_none_is_told(link):
    assert link.address.startswith("tcp/127.0.0.1:")
    with pytest.raises(NoNetwork, match="is no address"):
        WeakLink("what/is/this")


@pytest.mark.slow
@pytest.mark.parametrize("keeps_all", [False, True])
def test_what_a_slow_link_cannot_carry_is_dropped_or_waits_as_the_publisher_says(keeps_all):
    qos = Qos(history=KEEP_ALL, reliability=RELIABLE) if keeps_all else Qos(depth=1, reliability=BEST_EFFORT)
    with network() as make:
        there = make()
        every = Qos(history=KEEP_ALL, reliability=qos.reliability)
        heard = Inbox(there.graph.add_node("robot", "/").subscription("/big", UInt8MultiArray, every))
        last = Inbox(there.graph.add_node("end", "/").subscription("/last", Empty, Qos()))
        link = WeakLink(make.address)
        here = Side(link.address)
        here.link.begin()
        sender = here.graph.add_node("laptop", "/").publisher("/big", UInt8MultiArray, qos)
        told = here.graph.add_node("teller", "/").publisher("/last", Empty, Qos(history=KEEP_ALL))
        here.until(lambda: sender.targets and told.targets)
        here.link.settle()
        link.slow(300_000)
        for _ in range(400):
            sender.publish(UInt8MultiArray(data=bytes(2500)))
        link.slow(0)
        told.publish(Empty())
        last.take()  # another topic's message may overtake
        came = len([heard.take() for _ in range(400)]) if keeps_all else sum(1 for _ in iter(heard.source.take, None))
        here.link.close()
        link.close()
    assert (came == 400) == keeps_all and came > 20
