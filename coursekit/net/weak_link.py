"""A link that can be made as bad as Wi-Fi: a relay on loopback between a notebook and the address that it joins.

It simulates the effects of a bad radio on TCP: low bandwidth, delay, and interruptions. For messages of 3 kB and more
it carries only a notification: on one computer Zenoh passes the data in shared memory.
"""

from __future__ import annotations

import asyncio
import contextlib
import socket
import threading
import time
from collections.abc import Coroutine
from typing import Any, TypeVar

from .address import find_computer, read_address

PIECE = 8192
"""Bytes carried at once."""
BUFFER = 32768
"""Size of a connection's system buffers: small, so that the sender notices a slow link [bytes]."""
WAITING = 256
"""Maximum number of pieces in transit."""
CONNECT_SECONDS = 5.0
Result = TypeVar("Result")


class WeakLink:
    """Relays between its own `address` and another one, until `close`.

    Raises:
        NoNetwork: when the other address is invalid, or its host is unknown.
    """

    def __init__(self, to: str) -> None:
        self._family, self._to = find_computer(read_address(to))
        self._bytes_per_second = self._seconds = 0.0
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, name="coursekit-weak-link", daemon=True)
        self._thread.start()
        self._relays: set[asyncio.Future[None]] = set()
        self._port = 0
        self._carries = self._do(self._begin())

    @property
    def address(self) -> str:
        """The address at which to join it."""
        return f"tcp/127.0.0.1:{self._port}"

    def slow(self, bytes_per_second: float) -> None:
        """Limit the bandwidth per direction; 0 for no limit."""
        self._bytes_per_second = bytes_per_second

    def late(self, seconds: float) -> None:
        """Delay everything by so much, in each direction."""
        self._seconds = seconds

    def cut(self) -> None:
        """Carry nothing, as out of Wi-Fi range: both ends receive nothing, and new connections are refused."""
        self._do(self._cut())

    def mend(self) -> None:
        """Carry again; pieces in transit arrive now, if their receiver still waits."""
        self._do(self._mend())

    def close(self) -> None:
        """Close the relay."""
        if self._loop.is_running():
            self._do(self._end())
            self._loop.call_soon_threadsafe(self._loop.stop)
            self._thread.join(CONNECT_SECONDS)

    def __repr__(self) -> str:
        slow = f"{self._bytes_per_second:g} bytes a second" if self._bytes_per_second else ""
        late = f"{1e3 * self._seconds:g} ms late" if self._seconds else ""
        state = "cut" if not self._carries.is_set() else ", ".join(filter(None, (slow, late))) or "good"
        return f"[weak link: {state}]"

    # -- within the loop's thread

    def _do(self, work: Coroutine[Any, Any, Result]) -> Result:
        return asyncio.run_coroutine_threadsafe(work, self._loop).result(CONNECT_SECONDS)

    async def _begin(self) -> asyncio.Event:
        carries = asyncio.Event()
        carries.set()
        self._listen()
        return carries

    def _listen(self) -> None:
        self._listener = socket.create_server(("127.0.0.1", self._port))
        self._listener.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, BUFFER)
        self._listener.setblocking(False)
        self._port = self._listener.getsockname()[1]
        self._accepting = asyncio.ensure_future(self._accept(self._listener))

    async def _accept(self, listener: socket.socket) -> None:
        while True:
            near, _ = await self._loop.sock_accept(listener)
            relay = asyncio.ensure_future(self._relay(near))
            self._relays.add(relay)
            relay.add_done_callback(self._relays.discard)

    async def _cut(self) -> None:
        self._carries.clear()
        await self._end_listening()

    async def _mend(self) -> None:
        if not self._carries.is_set():
            self._listen()
            self._carries.set()

    async def _end_listening(self) -> None:
        self._accepting.cancel()
        await asyncio.wait([self._accepting])
        self._listener.close()

    async def _end(self) -> None:
        await self._end_listening()
        relays = list(self._relays)
        for relay in relays:
            relay.cancel()
        await asyncio.gather(*relays, return_exceptions=True)

    async def _relay(self, near: socket.socket) -> None:
        """Relay between an incoming connection and the other address, until either side closes."""
        with near, socket.socket(self._family, socket.SOCK_STREAM) as far, contextlib.suppress(OSError, TimeoutError):
            far.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, BUFFER)
            for end in (near, far):
                end.setblocking(False)
                end.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            await asyncio.wait_for(self._loop.sock_connect(far, self._to), CONNECT_SECONDS)
            await _first_of(self._carry(near, far), self._carry(far, near))

    async def _carry(self, source: socket.socket, sink: socket.socket) -> None:
        on_the_way: asyncio.Queue[tuple[float, bytes]] = asyncio.Queue(WAITING)
        await _first_of(self._take(source, on_the_way), self._bring(on_the_way, sink))

    async def _take(self, source: socket.socket, on_the_way: asyncio.Queue[tuple[float, bytes]]) -> None:
        while piece := await self._loop.sock_recv(source, PIECE):
            if self._bytes_per_second:
                await asyncio.sleep(len(piece) / self._bytes_per_second)
            await on_the_way.put((time.perf_counter() + self._seconds, piece))

    async def _bring(self, on_the_way: asyncio.Queue[tuple[float, bytes]], sink: socket.socket) -> None:
        while True:
            due, piece = await on_the_way.get()
            while (left := due - time.perf_counter()) > 0:
                await asyncio.sleep(left)  # repeated: on Windows, where a loop's clock ticks every 16 ms, sleep ends early
            await self._carries.wait()
            await self._loop.sock_sendall(sink, piece)


async def _first_of(*works: Coroutine[Any, Any, None]) -> None:
    """Run all until one of them ends, then cancel the others."""
    tasks = [asyncio.ensure_future(work) for work in works]
    try:
        await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)


__all__ = ["WeakLink"]
