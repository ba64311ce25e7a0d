"""Servers and notebooks as the browser tests see them."""

import json
import os
import secrets
import shutil
import signal
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import nbformat

from coursekit.cli.kernel_sockets import kernel_options
from coursekit.jupyter.kernel import write_kernelspec

from .page_scripts import ALL_RAN, ANSWERS, ASK, HAS_KERNEL, PROMPTS, TO_THE_END

_NO_NEWS = {"fetchNews": "false", "checkForUpdates": False, "doNotDisturbMode": True}
PATIENCE_MS = 60_000
_TELLS_ITS_STACKS = """
import faulthandler, os, signal
if hasattr(signal, "SIGUSR1"):  # Windows has none
    faulthandler.register(signal.SIGUSR1, file=open({folder!r} + f"/stacks-{{os.getpid()}}.txt", "w"))
"""


class Lab:
    """A JupyterLab server in a folder of its own."""

    def __init__(self, folder: Path, url: str, token: str) -> None:
        self.folder, self.url, self.token = folder, url, token

    def address(self, notebook: str) -> str:
        """Where a notebook of the folder is opened."""
        return f"{self.url}/lab/tree/{notebook}?token={self.token}&reset"

    def stacks(self) -> str:
        """Where every thread of every kernel of this server is; for a failure's report."""
        files = sorted(self.folder.glob("stacks-*.txt"))
        for path in files:
            try:
                os.kill(int(path.stem.removeprefix("stacks-")), signal.SIGUSR1)
            except OSError:
                continue
        time.sleep(1)
        return "\n".join(path.read_text() for path in files)


@contextmanager
def serving(folder: Path, command: list[str], env: dict[str, str]) -> Iterator[Lab]:
    """JupyterLab by this command on a free port of loopback, until the block ends."""
    startup = folder / "ipython" / "profile_default" / "startup"
    startup.mkdir(parents=True)
    (startup / "00_stacks.py").write_text(_TELLS_ITS_STACKS.format(folder=str(folder)))
    own = {"IPYTHONDIR": "ipython", "JUPYTER_CONFIG_DIR": "config", "JUPYTER_RUNTIME_DIR": "runtime"}
    own = {name: str(folder / under) for name, under in own.items()}
    own["COURSEKIT_RUNTIME_DIR"] = str(folder / "run")
    port, token = _free_port(), secrets.token_hex(16)
    command = [*command, f"--ServerApp.port={port}", "--ServerApp.port_retries=0"]
    command += [f"--IdentityProvider.token={token}", "--expose-app-in-browser"]
    command += ["--ServerApp.answer_yes=True"]  # Ctrl-C while the tests run reaches it as well, and it asks nobody
    with open(folder / "server.log", "w", encoding="utf-8") as log:
        server = subprocess.Popen(command, cwd=folder, env=env | own, stdout=log, stderr=log)
        try:
            _wait_for(f"http://127.0.0.1:{port}/api?token={token}", server)
            yield Lab(folder, f"http://127.0.0.1:{port}", token)
        finally:
            _end(server)


@contextmanager
def lab_in(folder: Path, domain_id: int) -> Iterator[Lab]:
    """JupyterLab in a folder, with the wall clock and a ROS domain of its own."""
    write_settings(folder)
    own = {"ROS_DOMAIN_ID": str(domain_id), "JUPYTERLAB_SETTINGS_DIR": str(folder / "settings")}
    own |= {"JUPYTER_PATH": str(write_kernelspec(folder)), "COURSEKIT_WORKSPACE": str(folder / "ros2_ws")}
    command = [sys.executable, "-m", "jupyterlab", "--no-browser", "--allow-root", "--ServerApp.ip=127.0.0.1"]
    command += [f"--ServerApp.root_dir={folder}", *kernel_options(folder / "runtime")]
    with serving(folder, command, {**os.environ, **own, "COURSEKIT_TIME": "wall"}) as served:
        yield served


def write_settings(folder: Path) -> None:
    """JupyterLab's settings as they are at first: the light theme, and no news."""
    shutil.rmtree(folder / "settings", ignore_errors=True)
    apputils = folder / "settings" / "@jupyterlab" / "apputils-extension"
    apputils.mkdir(parents=True)
    (apputils / "notification.jupyterlab-settings").write_text(json.dumps(_NO_NEWS))


def write_notebook(path: Path, cells: tuple[str, ...]) -> None:
    """A notebook with these code cells."""
    nb = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in cells])
    nb.metadata["kernelspec"] = {"name": "python3", "display_name": "Python 3", "language": "python"}
    nbformat.write(nb, path)


def start_beside(file: str) -> str:
    """A cell that runs a file of the workspace as a program beside the notebook."""
    return f"""import runpy
from coursekit.processes.session import current
program = lambda: runpy.run_path(str(workspace() / "{file}"), run_name="__main__")
started = current().start(program, name="{file[:-3]}")"""


def _end(server: subprocess.Popen) -> None:
    server.terminate()
    try:
        server.wait(60)
    except subprocess.TimeoutExpired:
        warnings.warn("JupyterLab did not end within a minute: killed", stacklevel=2)
        server.kill()
        server.wait()


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def _wait_for(url: str, server: subprocess.Popen) -> None:
    give_up = time.monotonic() + 120
    while time.monotonic() < give_up and server.poll() is None:
        try:
            urllib.request.urlopen(url, timeout=2).close()
            return
        except (urllib.error.URLError, OSError):
            time.sleep(0.2)
    raise RuntimeError(f"JupyterLab did not start; see {server.args}")


class Notebook:
    """An open notebook: `page` is playwright's, `run()` runs all its cells."""

    def __init__(self, page: Any, lab: Lab, name: str) -> None:
        self.page, self.lab, self.name = page, lab, name
        self.told: list[str] = []
        page.on("console", lambda message: self.told.append(f"{message.type}: {message.text}"))
        page.on("pageerror", lambda error: self.told.append(f"uncaught: {error}"))
        page.goto(lab.address(name), timeout=PATIENCE_MS)
        self._wait_until_it_answers()

    def run(self) -> None:
        """Run all cells, wait until each has its number, and look at the last: JupyterLab draws cells out of sight late.

        JupyterLab's web socket can lose a request on a busy machine and then waits for ever: the page is loaded
        anew, once, and that is said.
        """
        if not self._all_ran():
            warnings.warn(f"{self.name}: not all cells ran, once more. {self._state()}", stacklevel=2)
            self.load_again()
            assert self._all_ran(), f"not all cells ran: {self._state()}"
        self.page.evaluate(TO_THE_END)

    def load_again(self) -> None:
        """The page anew, with the same kernel."""
        self.page.reload(timeout=PATIENCE_MS)
        self._wait_until_it_answers()

    def run_to(self, text: str) -> int:
        """Run the cells one after the other up to the first that contains `text`, as Shift+Enter does."""
        return self.page.evaluate(
            """async (text) => {
                const panel = jupyterapp.shell.currentWidget;
                const until = panel.content.widgets.findIndex((cell) =>
                  cell.model.type === 'code' && cell.model.sharedModel.getSource().includes(text));
                for (let i = panel.courseRun ?? 0; i <= until; i++) {
                    panel.content.activeCellIndex = i;
                    panel.content.deselectAll();
                    await jupyterapp.commands.execute('notebook:run-cell');
                }
                panel.courseRun = until + 1;
                return until;
            }""",
            text,
        )

    def text(self) -> str:
        """What the outputs say."""
        return "\n".join(self.page.locator(".jp-OutputArea-output").all_inner_texts())

    def report(self) -> str:
        """What the page shows and what the browser and the server told, for a failure's report."""
        log = (self.lab.folder / "server.log").read_text()
        told = "\n".join(line[:300] for line in self.told[-40:])
        return f"{self.text()[-6000:]}\n--- browser\n{told}\n--- kernels\n{self.lab.stacks()}\n--- server\n{log[-2000:]}"

    def ask(self, code: str) -> str:
        """Run code in the notebook's kernel, beside its cells; what it prints."""
        return self.page.evaluate(ASK, code)

    def eventually(self, code: str, *wanted: str, patience: float = 30.0) -> None:
        """Ask until the answer is one of these."""
        give_up = time.monotonic() + patience
        while (answer := self.ask(code).strip()) not in wanted:
            assert time.monotonic() < give_up, f"{code}: {answer}, not {' or '.join(wanted)}"
            self.page.wait_for_timeout(100)

    def _all_ran(self) -> bool:
        from playwright.sync_api import TimeoutError as Late

        self.page.evaluate("void window.jupyterapp.commands.execute('notebook:run-all-cells')")
        try:
            self.page.wait_for_function(ALL_RAN, timeout=PATIENCE_MS)
        except Late:
            return False
        return True

    def _state(self) -> str:
        return f"{self.page.evaluate(PROMPTS)}\n{self.lab.stacks()}"

    def _wait_until_it_answers(self) -> None:
        """A connection that is still being made loses requests: ask until one is answered."""
        for _ in range(8):
            self.page.wait_for_selector(".jp-NotebookPanel .jp-CodeCell", timeout=PATIENCE_MS)
            self.page.wait_for_function(HAS_KERNEL, timeout=PATIENCE_MS)
            if self.page.evaluate(ANSWERS):
                return
            self.page.reload(timeout=PATIENCE_MS)
        raise RuntimeError(f"the kernel does not answer\n{self.lab.stacks()}")


def open_page(browser: Any, width: int, height: int) -> Any:
    """A new page of this size."""
    page = browser.new_page()
    page.set_viewport_size({"width": width, "height": height})
    return page


def close(page: Any) -> None:
    """End the page, also one that never came up, and its kernel: a page with a view left open slows all that follow."""
    try:
        page.evaluate("void window.jupyterapp?.shell.currentWidget?.sessionContext?.shutdown()")
        page.wait_for_timeout(300)
    finally:
        page.close()


def set_theme(page: Any, *, light: bool) -> None:
    """Have the page in the light or in the dark; its server remembers that."""
    name = "JupyterLab Light" if light else "JupyterLab Dark"
    page.evaluate("(name) => jupyterapp.commands.execute('apputils:change-theme', { theme: name })", name)
    shown = "(light) => document.body.dataset.jpThemeLight === light"
    page.wait_for_function(shown, arg=str(light).lower(), timeout=20_000)


def settled(page: Any, read: Callable[[], Any], patience: float = 20.0) -> Any:
    """What `read` gives once it has been the same for half a second."""
    give_up = time.monotonic() + patience
    last = read()
    while time.monotonic() < give_up:
        page.wait_for_timeout(500)
        last, before = read(), last
        if last == before:
            return last
    raise AssertionError(f"still changing: {last}")
