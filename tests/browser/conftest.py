"""JupyterLab on loopback and a headless Chromium that looks at it; skipped, loudly, without Chromium."""

import json
import os
import secrets
import shutil
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
import warnings
from pathlib import Path

import nbformat
import pytest

PATIENCE_MS = 60_000
_NO_NEWS = {"fetchNews": "false", "checkForUpdates": False, "doNotDisturbMode": True}


def chromium():
    """The browser's file, None where there is none."""
    return next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


@pytest.fixture(scope="session")
def browser():
    """A headless Chromium."""
    playwright = pytest.importorskip("playwright.sync_api", reason="no playwright: pip install playwright")
    path = chromium()
    if path is None:
        warnings.warn("No Chromium: the browser tests did NOT run (apt-get install chromium)", stacklevel=1)
        pytest.skip("no Chromium: apt-get install --no-install-recommends chromium")
    with playwright.sync_playwright() as driver:
        opened = driver.chromium.launch(executable_path=path, args=["--no-sandbox"])
        yield opened
        opened.close()


class Lab:
    """A JupyterLab server in a folder of its own."""

    def __init__(self, folder: Path, url: str, token: str) -> None:
        self.folder, self.url, self.token = folder, url, token

    def address(self, notebook: str) -> str:
        """Where a notebook of the folder is opened."""
        return f"{self.url}/lab/tree/{notebook}?token={self.token}&reset"


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def _wait_for(url: str, server: subprocess.Popen) -> None:
    give_up = time.monotonic() + 60
    while time.monotonic() < give_up and server.poll() is None:
        try:
            urllib.request.urlopen(url, timeout=2).close()
            return
        except (urllib.error.URLError, OSError):
            time.sleep(0.2)
    raise RuntimeError(f"JupyterLab did not start; see {server.args}")


@pytest.fixture(scope="module")
def lab(tmp_path_factory, browser):
    """JupyterLab, with a ROS domain of its own."""
    folder = tmp_path_factory.mktemp("lab")
    settings = folder / "settings" / "@jupyterlab" / "apputils-extension"
    settings.mkdir(parents=True)
    (settings / "notification.jupyterlab-settings").write_text(json.dumps(_NO_NEWS))
    port, token = _free_port(), secrets.token_hex(16)
    own = {"ROS_DOMAIN_ID": str(100 + os.getpid() % 100), "JUPYTERLAB_SETTINGS_DIR": str(folder / "settings")}
    own |= {name: str(folder / name) for name in ("JUPYTER_CONFIG_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR")}
    own |= {"COURSEKIT_RUNTIME_DIR": str(folder / "run"), "COURSEKIT_TIME": "wall"}
    command = [sys.executable, "-m", "jupyterlab", "--no-browser", "--expose-app-in-browser", "--allow-root"]
    command += ["--ServerApp.ip=127.0.0.1", f"--ServerApp.port={port}", "--ServerApp.port_retries=0"]
    command += [f"--IdentityProvider.token={token}", f"--ServerApp.root_dir={folder}"]
    with open(folder / "server.log", "w") as log:
        server = subprocess.Popen(command, cwd=folder, env={**os.environ, **own}, stdout=log, stderr=log)
        try:
            _wait_for(f"http://127.0.0.1:{port}/api?token={token}", server)
            yield Lab(folder, f"http://127.0.0.1:{port}", token)
        finally:
            server.terminate()
            server.wait(20)


class Notebook:
    """An open notebook: `page` is playwright's, `run()` runs all its cells."""

    def __init__(self, page, name: str) -> None:
        self.page, self.name = page, name

    def run(self) -> None:
        """Run all cells and wait until the kernel is idle again."""
        self.page.evaluate("window.jupyterapp.commands.execute('notebook:run-all-cells')")
        self.page.wait_for_function(
            "() => { const cells = [...document.querySelectorAll('.jp-CodeCell .jp-InputArea-prompt')];"
            " return cells.length && cells.every((one) => /\\[\\d+\\]/.test(one.textContent)); }",
            timeout=PATIENCE_MS,
        )

    def wait_until_it_answers(self) -> None:
        """A connection that is still being made loses requests: ask until one is answered."""
        for _ in range(8):
            if self.page.evaluate(
                """async () => {
                    const kernel = jupyterapp?.shell.currentWidget?.sessionContext?.session?.kernel;
                    const asked = async () => {
                        await kernel.info;
                        await kernel.requestExecute({ code: 'None', store_history: false }).done;
                        return kernel.connectionStatus === 'connected';
                    };
                    const late = new Promise((done) => setTimeout(() => done(false), 8000));
                    return kernel ? await Promise.race([asked(), late]) : await late;
                }"""
            ):
                return
            self.page.reload(timeout=PATIENCE_MS)
            self.page.wait_for_selector(".jp-NotebookPanel .jp-CodeCell", timeout=PATIENCE_MS)
        raise RuntimeError("the kernel does not answer")

    def text(self) -> str:
        """What the outputs say."""
        return "\n".join(self.page.locator(".jp-OutputArea-output").all_inner_texts())

    def ask(self, code: str) -> str:
        """Run code in the notebook's kernel, beside its cells; what it prints."""
        return self.page.evaluate(
            """async (code) => {
                const panel = window.jupyterapp.shell.currentWidget;
                const kernel = panel.sessionContext.session.kernel;
                const future = kernel.requestExecute({ code, store_history: false });
                let text = '';
                future.onIOPub = (message) => {
                  if (message.header.msg_type === 'stream') text += message.content.text;
                  if (message.header.msg_type === 'error') text += message.content.traceback.join('\\n');
                };
                await future.done;
                return text;
            }""",
            code,
        )


@pytest.fixture
def notebook(lab, browser, request):
    """notebook("cell 1", "cell 2", ...) writes a notebook, opens it and waits for its kernel."""
    opened = []

    def open_(*cells: str, width: int = 1100, height: int = 1000) -> Notebook:
        name = f"{request.node.name}.ipynb"
        made = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in cells])
        made.metadata["kernelspec"] = {"name": "python3", "display_name": "Python 3", "language": "python"}
        nbformat.write(made, lab.folder / name)
        page = browser.new_page(viewport={"width": width, "height": height})
        opened.append(page)
        page.goto(lab.address(name), timeout=PATIENCE_MS)
        page.wait_for_selector(".jp-NotebookPanel .jp-CodeCell", timeout=PATIENCE_MS)
        page.wait_for_function(
            "() => jupyterapp?.shell.currentWidget?.sessionContext?.session?.kernel?.status === 'idle'",
            timeout=PATIENCE_MS,
        )
        made = Notebook(page, name)
        made.wait_until_it_answers()
        return made

    yield open_
    for page in opened:
        page.evaluate("window.jupyterapp.shell.currentWidget?.sessionContext.shutdown()")
        page.close()


@pytest.fixture
def picture(request):
    """picture(locator, "name") keeps a screenshot where COURSEKIT_PICTURES says, if it says so."""

    def keep(locator, name: str) -> None:
        folder = os.environ.get("COURSEKIT_PICTURES")
        if folder:
            Path(folder).mkdir(parents=True, exist_ok=True)
            locator.screenshot(path=str(Path(folder) / f"{name}.png"))

    return keep
