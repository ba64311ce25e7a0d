"""Kernels of `coursekit lab` listen at Unix sockets, where two cannot choose the same; else their ports are encrypted."""

import os
import tempfile
from contextlib import contextmanager
from pathlib import Path

import pytest
from jupyter_client.kernelspec import KernelSpecManager
from jupyter_client.manager import KernelManager
from traitlets.config import Config
from traitlets.config.loader import KVArgParseConfigLoader

from coursekit.cli.kernel_sockets import kernel_options
from coursekit.jupyter.kernel import write_kernelspec

LONGEST_NAME = len(f"/kernel-{'0' * 36}-ipc-5")
ENCRYPTED = ["--KernelManager.transport_encryption=auto"]


def config_of(options: list[str]) -> Config:
    """What a Jupyter server understands of these options."""
    return KVArgParseConfigLoader().load_config(options)


@pytest.fixture
def runtime():
    """A folder with a short name."""
    with tempfile.TemporaryDirectory() as folder:
        yield Path(folder)


@contextmanager
def kernel_in(folder: Path, options: list[str]):
    """A kernel of the course that runs."""
    specs = KernelSpecManager(kernel_dirs=[str(write_kernelspec(folder) / "kernels")], ensure_native_kernel=False)
    file = str(folder / f"kernel-{'0' * 36}.json")
    kernel = KernelManager(config=config_of(options), kernel_spec_manager=specs, kernel_name="python3", connection_file=file)
    with open(folder / "log", "w", encoding="utf-8") as log:
        kernel.start_kernel(stdout=log, stderr=log)
        try:
            yield kernel
        finally:
            kernel.shutdown_kernel(now=True)


def answers(kernel: KernelManager) -> None:
    """Wait until the kernel answers."""
    client = kernel.client()
    client.start_channels()
    client.wait_for_ready(timeout=60)
    client.stop_channels()


@pytest.mark.skipif(os.name == "nt", reason="there kernels have ports")
def test_a_kernel_listens_at_its_files_and_a_restarted_one_answers(runtime) -> None:
    with kernel_in(runtime, kernel_options(runtime)) as kernel:
        for _ in range(2):
            answers(kernel)
            assert sum(path.is_socket() for path in runtime.iterdir()) == 5
            kernel.restart_kernel(now=True)
        answers(kernel)


def test_where_a_kernel_has_ports_they_are_encrypted_and_nothing_warns(runtime) -> None:
    with kernel_in(runtime, ENCRYPTED) as kernel:
        answers(kernel)
        assert kernel.transport == "tcp"
        assert kernel.curve_secretkey
    assert "without encryption" not in (runtime / "log").read_text(encoding="utf-8")


@pytest.mark.skipif(os.name == "nt", reason="there kernels have ports")
@pytest.mark.parametrize("length", [40, 103 - LONGEST_NAME, 108 - LONGEST_NAME, 200])
def test_a_folder_that_is_too_long_for_a_socket_leaves_ports(runtime, length) -> None:
    folder = Path(f"{runtime}/{'x' * length}"[:length])
    fits = length + LONGEST_NAME <= 103  # macOS; Linux has room for four more
    assert ("--KernelManager.transport=ipc" in kernel_options(folder)) is fits
    assert not list(folder.glob("*"))


def test_where_nothing_can_listen_kernels_have_ports(runtime) -> None:
    (runtime / "file").write_text("")
    assert kernel_options(runtime / "file") == ENCRYPTED


def test_windows_has_ports(runtime, monkeypatch) -> None:
    monkeypatch.setattr("coursekit.cli.kernel_sockets.HAS_UNIX", False)
    assert kernel_options(runtime) == ENCRYPTED
