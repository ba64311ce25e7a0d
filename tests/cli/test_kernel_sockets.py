"""Kernels of `coursekit lab` listen at Unix sockets: no port that two of them could choose at once."""

import os
import tempfile
from pathlib import Path

import pytest
from jupyter_client.manager import KernelManager
from traitlets.config import Config
from traitlets.config.loader import KVArgParseConfigLoader

from coursekit.cli.kernel_sockets import kernel_options
from coursekit.systems import which


def config_of(options: list[str]) -> Config:
    """What a Jupyter server understands of these options."""
    return KVArgParseConfigLoader().load_config(options)


@pytest.fixture
def runtime():
    """A folder with a short name."""
    with tempfile.TemporaryDirectory() as folder:
        yield Path(folder)


@pytest.mark.skipif(os.name == "nt", reason="there kernels have ports")
def test_a_kernel_listens_at_its_files_and_a_restarted_one_answers(runtime) -> None:
    kernel = KernelManager(
        config=config_of(kernel_options(runtime)), connection_file=str(runtime / f"kernel-{'0' * 36}.json")
    )
    assert kernel.transport == "ipc"
    kernel.start_kernel()
    try:
        for _ in range(2):
            client = kernel.client()
            client.start_channels()
            client.wait_for_ready(timeout=60)
            client.stop_channels()
            assert sum(one.is_socket() for one in runtime.iterdir()) == 5
            kernel.restart_kernel(now=True)
    finally:
        kernel.shutdown_kernel(now=True)


@pytest.mark.parametrize("length", [50, 53, 54, 200])
def test_a_folder_that_is_too_long_for_a_socket_leaves_jupyter_s_ports(length) -> None:
    runtime = Path("/" + "x" * (length - 1))
    longest = len(f"{runtime}/kernel-{'0' * 36}-ipc-5")
    assert bool(kernel_options(runtime)) is (longest <= 103)


def test_windows_has_ports(monkeypatch) -> None:
    monkeypatch.setattr(which, "WINDOWS", True)
    assert kernel_options(Path("/run")) == []
