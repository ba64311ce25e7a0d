"""The course's kernels hear a request that comes in the moment of a reply; JupyterLab starts them."""

import asyncio
import json
import subprocess
import sys
from threading import Thread
from types import SimpleNamespace

import pytest
import zmq
from ipykernel.shellchannel import ShellChannelThread
from jupyter_client.kernelspec import KernelSpecManager
from zmq.eventloop.zmqstream import ZMQStream

from coursekit.jupyter.kernel import hear_all, write_kernelspec

TURNS = 200


class Interrupted(zmq.Socket):
    """The kernel's end: in the moment of its first reply comes a request more."""

    asker = None

    def send_multipart(self, *args, **kwargs):
        if self.asker is not None:
            asker, self.asker = self.asker, None
            asker.send(b"second")
        return super().send_multipart(*args, **kwargs)


@pytest.fixture
def kernel():
    """What `hear_all` needs of a kernel, and `heard`: the requests that were read."""
    context = zmq.Context()
    socket = Interrupted(context, zmq.ROUTER)
    socket.bind("inproc://shell")
    asker = context.socket(zmq.DEALER)
    asker.connect("inproc://shell")
    thread = ShellChannelThread(context, socket)
    stream = ZMQStream(socket, thread.io_loop)
    yield SimpleNamespace(shell_channel_thread=thread, shell_stream=stream, socket=socket, asker=asker)
    socket.close(linger=0)
    context.destroy(linger=0)
    thread.io_loop.close()


def requests_heard(kernel):
    """Ask, reply, and ask again while the reply is sent."""
    thread, heard = kernel.shell_channel_thread, []

    def answer(frames):
        heard.append(bytes(frames[-1]))
        if len(heard) == 1:
            kernel.socket.asker = kernel.asker
            thread.manager._main_to_shell_channel.from_socket.send_multipart([frames[0], b"reply"])

    async def turns():
        kernel.shell_stream.on_recv(answer, copy=False)
        kernel.asker.send(b"first")
        for _ in range(TURNS):
            await asyncio.sleep(0)  # one turn of the loop

    alone = Thread(target=thread.io_loop.run_sync, args=(turns,))  # this one may have a loop already
    alone.start()
    alone.join()
    return heard


def test_a_request_in_the_moment_of_a_reply_is_heard(kernel):
    hear_all(kernel)
    assert requests_heard(kernel) == [b"first", b"second"]


def test_without_help_it_is_lost(kernel, monkeypatch):
    """If this fails, ipykernel is mended and `hear_all` can go."""
    monkeypatch.setattr("ipykernel.subshell_manager.SHELL_CHANNEL_THREAD_NAME", "MainThread")
    assert requests_heard(kernel) == [b"first"]


def test_jupyter_finds_this_kernel_before_the_usual_one(tmp_path, monkeypatch):
    monkeypatch.setenv("JUPYTER_PATH", str(write_kernelspec(tmp_path)))
    specs = json.loads(subprocess.run([sys.executable, "-m", "jupyter", "kernelspec", "list", "--json"],
                                      capture_output=True, check=True).stdout)  # fmt: skip
    assert specs["kernelspecs"]["python3"]["spec"]["argv"][1:3] == ["-m", "coursekit.jupyter.kernel"]
    assert KernelSpecManager().get_kernel_spec("python3").argv[2] == "coursekit.jupyter.kernel"
