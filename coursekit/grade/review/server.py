"""Serve the pages to this computer's browser only: on loopback, under an unguessable address."""

from __future__ import annotations

import asyncio
import json
import secrets
from collections.abc import Callable
from typing import Any

from tornado.httpserver import HTTPServer
from tornado.netutil import bind_sockets
from tornado.web import Application, HTTPError, RequestHandler, StaticFileHandler

from coursekit.files import read_bytes

from .marks import Marks
from .pages import STATIC, class_page, marking_page

_HOSTS = ("127.0.0.1", "localhost")
_POLICY = (
    "default-src 'none'; img-src 'self' data:; style-src 'self' 'unsafe-inline'; script-src 'self'; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
_HEADERS = {
    "Content-Security-Policy": _POLICY,
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cache-Control": "no-store",
}
_LONGEST = 64 << 10
"""The maximum size of a page's request [bytes]."""


class _Safe(RequestHandler):
    """Answers only requests that use this computer's own name, which prevents access by other sites' pages."""

    def initialize(self, marks: Marks) -> None:
        self.marks = marks

    def set_default_headers(self) -> None:
        for name, value in _HEADERS.items():
            self.set_header(name, value)

    def prepare(self) -> None:
        if self.request.host_name not in _HOSTS:
            raise HTTPError(403)


class _Pages(_Safe):
    """A person's page, and the input on it."""

    def get(self, key: str) -> None:
        if key not in self.marks.records:
            raise HTTPError(404)
        self.finish(marking_page(self.marks, key))

    def post(self, key: str) -> None:
        try:
            said = json.loads(self.request.body)
            exercise = str(said["exercise"])
            write: Callable[[str, str, str], None] = self.marks.points if "points" in said else self.marks.comment
            write(key, exercise, str(said["points" if "points" in said else "comment"]))
        except (LookupError, TypeError, ValueError, RecursionError) as error:
            self.finish({"error": f"It is not saved: {error}."})
            return
        self.finish(self.marks.shown(key, exercise) | {"told": self.marks.remark(key, exercise)})


class _Class(_Safe):
    """The page of the class."""

    def get(self) -> None:
        self.finish(class_page(self.marks))


class _Picture(_Safe):
    """The histogram of the points."""

    def get(self) -> None:
        try:
            self.set_header("Content-Type", "image/png")
            self.finish(read_bytes(self.marks.folder / "histogram.png"))
        except OSError:
            raise HTTPError(404) from None


def application(marks: Marks, token: str) -> Application:
    """Return the application with the pages under `/TOKEN/`, and nothing elsewhere."""
    facts: dict[str, Any] = {"marks": marks}
    return Application([
        (rf"/{token}/class\.html", _Class, facts),
        (rf"/{token}/histogram\.png", _Picture, facts),
        (rf"/{token}/static/(review\.js|review\.css)", StaticFileHandler, {"path": str(STATIC)}),
        (rf"/{token}/([\w-]+)\.html", _Pages, facts),
    ], log_function=lambda handler: None)  # fmt: skip


async def _serve(marks: Marks, ready: Callable[[str], None]) -> None:
    token = secrets.token_urlsafe(24)
    server = HTTPServer(application(marks, token), max_body_size=_LONGEST)
    sockets = bind_sockets(0, "127.0.0.1")
    server.add_sockets(sockets)
    try:
        ready(f"http://127.0.0.1:{sockets[0].getsockname()[1]}/{token}/class.html")
        await asyncio.Event().wait()
    finally:
        server.stop()


def serve(marks: Marks, ready: Callable[[str], None]) -> None:
    """Serve until Ctrl-C, then write all pages and tables; `ready(address)` is called once the server accepts requests."""
    try:
        asyncio.run(_serve(marks, ready))
    except KeyboardInterrupt:
        pass
    finally:
        marks.finish()
