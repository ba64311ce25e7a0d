"""`python -m coursekit.jupyter.kernel`: IPython's kernel with the lab preloaded and with lost requests fixed.

ipykernel 7.0 to 7.3 sends replies past the stream that reads requests from the same socket. A request that arrives
at that moment is never read, nor is any later one: the kernel hangs until it is restarted (ipykernel issue 1554).
Later versions fix this, but in 7.4.0 synced traits of widgets get stuck, so the course patches 7.3 instead.
"""

from __future__ import annotations

import functools
import json
import shutil
import sys
from pathlib import Path
from typing import Any

from coursekit import wiring
from coursekit.processes.patching import KERNEL, Change, Patch

_STILLS = Path(__file__).parent / "labextension"


def hear_all(kernel: Any) -> None:
    """Send a kernel's replies through the stream that reads its requests; call it in the thread that made the kernel."""
    thread = getattr(kernel, "shell_channel_thread", None)
    if thread is None or hasattr(thread.manager, "_shell_stream"):
        return  # versions before 7 and after 7.3 do so themselves
    manager, reply = thread.manager, kernel.shell_stream.send_multipart
    manager._send_on_shell_channel = reply  # for subshells created later

    def take() -> None:
        pairs = [
            manager._main_to_shell_channel,
            *(subshell.subshell_to_shell_channel for subshell in manager._cache.values()),
        ]
        for pair in pairs:
            pair.on_recv(thread.io_loop, reply)

    thread.io_loop.add_callback(take)


def keep_output_in_cells(shell: Any) -> None:
    """Attach the output of threads to the cell that ran last, never to a widget's message.

    A thread started outside of any request prints to the latest request. A viewer sends thirty messages a second, and
    output attached to a message is not shown: only cells may be that latest request. The publisher tells whether this
    ipykernel has a latest request at all: the shell itself has the name only from its first request on.
    """
    if not hasattr(shell.display_pub, "_parent_header_global") or hasattr(shell.set_parent, "for_cells"):
        return
    set_parent = shell.set_parent

    def take(request: dict[str, Any]) -> None:
        header = request.get("header", {})
        if header.get("msg_type") == "execute_request" and not request.get("content", {}).get("silent"):
            set_parent(request)
            return
        shell._parent_header.set(request)  # for this thread only
        for publisher in (shell.displayhook, shell.display_pub, sys.stdout, sys.stderr):
            if hasattr(publisher, "_parent_header"):
                publisher._parent_header.set(header)

    take.for_cells = True  # type: ignore[attr-defined]
    shell.set_parent = take


def patches() -> list[Patch]:
    """Return the changes to a kernel of the course, for as long as it runs."""
    test = "tests/jupyter/test_kernel"
    return [
        Change("ipykernel: shell_channel_thread.manager", hear_all, "ipykernel 7.3 goes deaf when a request meets a reply",
               f"{test}.py", KERNEL),
        Change("ipykernel: shell.set_parent", keep_output_in_cells, "what threads print goes to a cell, not to a widget",
               f"{test}_output.py", KERNEL),
    ]  # fmt: skip


def write_kernelspec(folder: Path) -> Path:
    """Make JupyterLab start its Python kernels with this module. Returns a folder for JUPYTER_PATH, below `folder`.

    The folder also holds an extension that shows stills in place of views whose kernel has gone.
    """
    place = folder / ".coursekit" / "jupyter"
    spec = {
        "argv": [sys.executable, "-m", __name__, "-f", "{connection_file}"],
        "display_name": "Python 3 (ipykernel)",
        "language": "python",
        "metadata": {"debugger": True, "supported_encryption": "curve"},
    }
    file = place / "kernels" / "python3" / "kernel.json"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(spec, indent=1), encoding="utf-8")
    shutil.copytree(_STILLS, place / "labextensions" / "coursekit-stills", dirs_exist_ok=True)
    return place


def load_lab(shell: Any) -> None:
    """Load the names and magics of the lab into a kernel before its first cell, also after a restart."""
    try:
        lab = wiring.load(wiring.LAB)
    except Exception as error:  # a kernel that starts and reports the error is better than none
        shell.events.register("pre_run_cell", functools.partial(_say_once, shell, f"The lab did not start: {error!r}"))
        return
    names = {name: getattr(lab, name) for name in lab.__all__}
    shell.user_ns.update(names)
    shell.user_ns_hidden.update(names)


def _say_once(shell: Any, text: str, *_event: Any) -> None:
    callbacks = shell.events.callbacks["pre_run_cell"]
    callbacks[:] = [callback for callback in callbacks if getattr(callback, "func", None) is not _say_once]
    print(f"{text}\nWhat is wrong, and the cure: !coursekit doctor", file=sys.stderr)


def main() -> None:
    """Run a kernel of the course."""
    from ipykernel.kernelapp import IPKernelApp

    class KernelApp(IPKernelApp):
        def init_kernel(self) -> None:
            super().init_kernel()
            hear_all(self.kernel)
            keep_output_in_cells(self.kernel.shell)

        def init_code(self) -> None:
            super().init_code()
            load_lab(self.shell)

    KernelApp.launch_instance()


if __name__ == "__main__":
    main()
