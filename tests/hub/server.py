"""A real JupyterHub on loopback with the configuration of `deploy/`, whose students have homes of their own."""

from __future__ import annotations

import contextlib
import os
import secrets
import shutil
import socket
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROXY = "configurable-http-proxy"
_CONFIG = """
load_subconfig({deploy!r})
c.JupyterHub.bind_url = "http://127.0.0.1:{port}"
c.JupyterHub.hub_port = {hub_port}
c.JupyterHub.db_url = "sqlite:///{folder}/hub.sqlite"
c.JupyterHub.cookie_secret_file = "{folder}/cookie_secret"
c.JupyterHub.concurrent_spawn_limit = 4
c.ConfigurableHTTPProxy.command = {proxy!r}
c.ConfigurableHTTPProxy.api_url = "http://127.0.0.1:{proxy_port}"
c.ConfigurableHTTPProxy.pid_file = "{folder}/proxy.pid"
c.JupyterHub.authenticator_class = "dummy"
c.DummyAuthenticator.password = {token!r}
c.Authenticator.allow_all = True
c.JupyterHub.spawner_class = "simple"
c.SimpleLocalProcessSpawner.home_dir_template = "{folder}/home/{{username}}"
c.Spawner.environment = {{
    **c.Spawner.environment,
    # Here all students are one user of Linux.
    "COURSEKIT_RUNTIME_DIR": lambda spawner: f"{folder}/run/{{spawner.user.name}}",
}}
c.JupyterHub.services = [{{"name": "teacher", "api_token": {token!r}}}]
c.JupyterHub.load_roles = [
    {{"name": "teacher", "scopes": ["admin:users", "admin:servers", "access:servers"], "services": ["teacher"]}}
]
"""


def missing() -> str:
    """What is not there of what a hub needs; '' when all is."""
    try:
        import jupyterhub  # noqa: F401
    except ImportError:
        return 'JupyterHub is not installed: pip install "coursekit[hub]"'
    return "" if proxy() else f"{PROXY} is not installed: npm install -g {PROXY}"


def proxy() -> str:
    """The program that stands in front of the hub; '' where there is none."""
    beside = ROOT / ".venv" / "node_modules" / ".bin" / PROXY
    return str(beside) if beside.exists() else shutil.which(PROXY) or ""


def free_ports(count: int) -> list[int]:
    """Ports that nothing listens on."""
    open_ = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [listener.getsockname()[1] for listener in open_]
    for listener in open_:
        listener.close()
    return ports


class Hub:
    """The hub; `api` asks it as the teacher's service."""

    def __init__(self, folder: Path, **environment: str) -> None:
        port, hub_port, proxy_port = free_ports(3)
        self.folder, self.token, self.url = folder, secrets.token_hex(16), f"http://127.0.0.1:{port}"
        (folder / "home").mkdir(parents=True)
        text = _CONFIG.format(
            port=port, hub_port=hub_port, proxy_port=proxy_port, proxy=[proxy()],
            deploy=str(ROOT / "deploy" / "hub_config.py"), folder=folder, token=self.token,
        )  # fmt: skip
        config = folder / "jupyterhub_config.py"
        config.write_text(text, encoding="utf-8")
        self._log = open(folder / "hub.log", "wb")  # noqa: SIM115  closed with the hub
        self._process = subprocess.Popen(
            [sys.executable, "-m", "jupyterhub", "-f", str(config)],
            cwd=folder, stdout=self._log, stderr=subprocess.STDOUT, env=os.environ | environment,
        )  # fmt: skip

    def log(self) -> str:
        """What the hub and its students' servers have printed."""
        return (self.folder / "hub.log").read_text(encoding="utf-8", errors="replace")

    def wait_until_ready(self) -> None:
        """Until the proxy listens and the hub behind it answers."""
        while self._process.poll() is None:
            with contextlib.suppress(OSError):  # also while the proxy has no hub yet
                self.request("GET", "/hub/api/")
                return
            time.sleep(0.1)
        raise AssertionError(self.log())

    def request(self, method: str, path: str, body: bytes | None = None) -> bytes:
        """What the hub or a student's server answers."""
        headers = {"Authorization": f"token {self.token}", "Content-Type": "application/json"}
        asked = urllib.request.Request(f"{self.url}{path}", body, headers, method=method)
        with urllib.request.urlopen(asked, timeout=180) as answer:
            return bytes(answer.read())

    def close(self) -> None:
        """End the hub, which ends its proxy and the students' servers."""
        self._process.terminate()
        self._process.wait(timeout=60)
        self._log.close()
