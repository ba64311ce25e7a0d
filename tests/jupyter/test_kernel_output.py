"""Output of threads goes to the cell that ran last, whatever widgets say meanwhile."""

import sys
from contextvars import ContextVar
from threading import Thread
from types import SimpleNamespace

import pytest

from coursekit.jupyter.kernel import keep_output_in_cells


class Part(SimpleNamespace):
    """What ipykernel's shell, streams and publishers have in common: a parent for here and one for everybody."""

    def __init__(self):
        super().__init__(_parent_header=ContextVar("parent"), _parent_header_global={})

    def set_parent(self, parent):
        self._parent_header_global = parent.get("header", parent)
        self._parent_header.set(self._parent_header_global)

    def parent_of_new_thread(self):
        parents = []
        thread = Thread(target=lambda: parents.append(self._parent_header.get(self._parent_header_global)))
        thread.start()
        thread.join()
        return parents[0]


def request(kind, number, **content):
    return {"header": {"msg_type": kind, "msg_id": number}, "content": content}


def shell_with(monkeypatch):
    """A shell, mended twice; to be made in the test itself, because pytest has its own stdout before."""
    kernel_shell = Part()
    del kernel_shell._parent_header_global  # ipykernel's shell has one only from its first request on
    kernel_shell.displayhook, kernel_shell.display_pub = Part(), Part()
    monkeypatch.setattr(sys, "stdout", Part())
    parts = [kernel_shell.displayhook, kernel_shell.display_pub, sys.stdout]

    def set_parent(parent):
        for part in parts:
            part.set_parent(parent)

    kernel_shell.set_parent, kernel_shell.parts = set_parent, parts
    keep_output_in_cells(kernel_shell)
    keep_output_in_cells(kernel_shell)
    return kernel_shell


@pytest.mark.parametrize("other", [request("comm_msg", 2), request("execute_request", 2, silent=True), {"header": {}}])
def test_a_message_that_is_no_cell_does_not_take_the_output_of_threads(monkeypatch, other):
    shell = shell_with(monkeypatch)
    shell.set_parent(request("execute_request", 1))
    shell.set_parent(other)
    assert [part.parent_of_new_thread().get("msg_id") for part in shell.parts] == [1, 1, 1]
    shell.set_parent(request("execute_request", 3))
    assert [part.parent_of_new_thread().get("msg_id") for part in shell.parts] == [3, 3, 3]


def test_what_answers_a_message_still_belongs_to_it(monkeypatch):
    """`with out:` in a button's function takes what was said in answer to the click."""
    shell = shell_with(monkeypatch)
    shell.set_parent(request("execute_request", 1))
    shell.set_parent(request("comm_msg", 2))
    assert [part._parent_header.get()["msg_id"] for part in shell.parts] == [2, 2, 2]
