"""Opening a Zenoh session: as a client of one router, or as the router; without multicast scouting in both cases."""

from __future__ import annotations

import contextlib
import json
import threading
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .address import knock, read_address
from .errors import NoNetwork

OPEN_SECONDS = 5.0
"""Timeout for a router to accept a client; after a wrong password there is no answer at all [s]."""
LEASE_SECONDS = 2.0
"""A link that is silent for this long is lost, together with its queued messages [s]."""

BUSY_SECONDS = 0.01
"""Time that a message waits for buffer space before it is dropped: threads on a busy computer may sleep this long [s]."""
SEND_BUFFER = 65536
"""Size of the system's send buffer: a slow link drops messages instead of delivering them seconds late [bytes]."""


@dataclass(frozen=True)
class Credentials:
    """The credentials for a router: a user and a password, and for TLS the certificate of the authority."""

    user: str = ""
    password: str = ""
    certificate: str = ""


def open_client(address: str, credentials: Credentials = Credentials(), seconds: float = OPEN_SECONDS) -> Any:
    """Open a Zenoh session with the router at a complete address.

    Raises:
        NoNetwork: when Zenoh is not installed, nothing listens at the address, or the router refuses the credentials.
    """
    zenoh = engine()
    knock(address, seconds)
    config = _quiet(zenoh, "client")
    _set(config, "connect/endpoints", [address])
    _set(config, "connect/timeout_ms", round(seconds * 1000))
    _set(config, "connect/exit_on_failure", True)
    if credentials.user:
        _set(config, "transport/auth/usrpwd/user", credentials.user)
        _set(config, "transport/auth/usrpwd/password", credentials.password)
    if credentials.certificate:
        _set(config, "transport/link/tls/root_ca_certificate", str(Path(credentials.certificate).resolve()))
    return _within(lambda: zenoh.open(config), seconds + 1.0, _refused(address, credentials))


def open_router(
    listen: list[str], users: Path | None = None, certificate: Path | None = None, key: Path | None = None
) -> Any:
    """Open a router that listens at these addresses; `users` is a file of lines USER:PASSWORD.

    Raises:
        NoNetwork: when Zenoh is not installed, or it cannot listen at an address.
    """
    zenoh = engine()
    config = _quiet(zenoh, "router")
    _set(config, "listen/endpoints", [read_address(text) for text in listen])
    _set(config, "listen/exit_on_failure", True)
    if users is not None:
        _set(config, "transport/auth/usrpwd/dictionary_file", str(users.resolve()))
    if certificate is not None and key is not None:
        _set(config, "transport/link/tls/listen_certificate", str(certificate.resolve()))
        _set(config, "transport/link/tls/listen_private_key", str(key.resolve()))
    why = f"Nobody can listen at {', '.join(listen)}: another program does, or the address is not this computer's."
    return _within(lambda: zenoh.open(config), OPEN_SECONDS, why)


def engine() -> Any:
    """Return the module `zenoh`; NoNetwork where it is not installed."""
    try:
        import xxhash  # noqa: F401  (what the tokens are told apart by)
        import zenoh
    except ImportError:
        raise NoNetwork('The network needs two more packages. Install them: pip install "coursekit[network]"') from None
    return zenoh


def _quiet(zenoh: Any, mode: str) -> Any:
    config = zenoh.Config()
    _set(config, "mode", mode)
    _set(config, "scouting/multicast/enabled", False)
    _set(config, "scouting/gossip/enabled", False)
    _set(config, "timestamping/enabled", True)
    _set(config, "transport/link/tx/lease", round(LEASE_SECONDS * 1000))
    _set(config, "transport/link/tx/queue/congestion_control/drop/wait_before_drop", round(BUSY_SECONDS * 1e6))
    _set(config, "transport/link/tcp/so_sndbuf", SEND_BUFFER)
    if mode == "client":
        _set(config, "listen/endpoints", [])
    return config


def _set(config: Any, name: str, value: object) -> None:
    config.insert_json5(name, json.dumps(value))


def _refused(address: str, credentials: Credentials) -> str:
    if address.startswith("tls/"):
        return f"{address} does not let this side in: wrong user or password, or a certificate that it does not show."
    if credentials.user:
        return f"{address} does not let '{credentials.user}' in: the user or the password is wrong, or it is no router."
    return f"{address} does not let this side in: it may ask for a user and a password: %network {address} --user NAME"


def _within(call: Callable[[], Any], seconds: float, refusal: str) -> Any:
    """Return the result of a call that may block for ever; NoNetwork after so many seconds."""
    result: list[Any] = []
    given_up = threading.Event()

    def run() -> None:
        with contextlib.suppress(Exception):
            opened = call()
            result.append(opened)
            if given_up.is_set():
                opened.close()

    thread = threading.Thread(target=run, name="coursekit-network-open", daemon=True)
    thread.start()
    thread.join(seconds)
    if not result:
        given_up.set()
        raise NoNetwork(refusal)
    return result[0]
