"""One student of the hub: starts their server, and runs cells in a kernel through the hub's proxy."""

from __future__ import annotations

import json
import time
import urllib.error
import uuid
from typing import Any

from websocket import create_connection

from .server import Hub

CELL_S = 600


class CellFailed(AssertionError):
    """A cell of a student's raised an error."""


class Student:
    """A user of the hub by that name."""

    def __init__(self, hub: Hub, name: str) -> None:
        self.hub, self.name = hub, name
        self.started_in = 0.0
        self._kernel = ""

    def start(self) -> None:
        """Ask for a server, as the browser does after logging in, and wait until it answers."""
        began = time.monotonic()
        self.hub.request("POST", f"/hub/api/users/{self.name}")
        while not self._is_accepted():
            time.sleep(1)  # as a browser does that is told to come again: the hub starts a few servers at a time
        self._wait_until_ready()
        self.started_in = time.monotonic() - began

    def _is_accepted(self) -> bool:
        try:
            self.hub.request("POST", f"/hub/api/users/{self.name}/server")
        except urllib.error.HTTPError as error:
            if error.code != 429:
                raise
            return False
        return True

    def _wait_until_ready(self) -> None:
        """The hub tells the progress of a start as a stream of events, which ends with the start."""
        told = self.hub.request("GET", f"/hub/api/users/{self.name}/server/progress").decode()
        events = [json.loads(line[5:]) for line in told.splitlines() if line.startswith("data:")]
        assert events[-1].get("ready"), (events, self.hub.log()[-3000:])

    def ask(self, method: str, path: str, body: Any = None) -> Any:
        """What the student's own server answers."""
        sent = None if body is None else json.dumps(body).encode()
        return json.loads(self.hub.request(method, f"/user/{self.name}/api/{path}", sent) or b"null")

    def open_kernel(self) -> None:
        """Start a kernel, and listen to it."""
        self._kernel = self.ask("POST", "kernels", {"name": "python3"})["id"]
        self.listen()

    def listen(self) -> None:
        """Listen to the kernel anew: who does not answer for two minutes is cut off, and only a cell that runs answers."""
        address = f"{self.hub.url.replace('http', 'ws')}/user/{self.name}/api/kernels/{self._kernel}/channels"
        self._socket = create_connection(address, timeout=CELL_S, header=[f"Authorization: token {self.hub.token}"])

    def run(self, code: str) -> str:
        """Run a cell; what it printed."""
        request = self._request(code)
        self._socket.send(json.dumps(request))
        printed = []
        while True:
            message = json.loads(self._socket.recv())
            if message.get("parent_header", {}).get("msg_id") != request["header"]["msg_id"]:
                continue
            kind, content = message["msg_type"], message["content"]
            if kind == "stream":
                printed.append(content["text"])
            elif kind == "error":
                raise CellFailed(f"{self.name}: {code}\n{content['ename']}: {content['evalue']}")
            elif kind == "status" and content["execution_state"] == "idle":
                return "".join(printed)

    @staticmethod
    def _request(code: str) -> dict[str, Any]:
        header = {"msg_id": uuid.uuid4().hex, "username": "", "session": uuid.uuid4().hex, "msg_type": "execute_request",
                  "version": "5.3"}  # fmt: skip
        content = {"code": code, "silent": False, "store_history": True, "user_expressions": {}, "allow_stdin": False}
        return {"header": header, "parent_header": {}, "metadata": {}, "content": content, "channel": "shell", "buffers": []}

    def close_kernel(self) -> None:
        """End the kernel."""
        self._socket.close()
        self.ask("DELETE", f"kernels/{self._kernel}")

    def stop(self) -> None:
        """End the server."""
        try:
            self.hub.request("DELETE", f"/hub/api/users/{self.name}/server")
        except urllib.error.HTTPError as error:
            assert error.code == 404, error  # it has ended already
