"""Programs that have other interpreters count for them, on both clocks: pools, executors, queues, locks."""

import os

import pytest

from coursekit.processes.current_process import current_process
from coursekit.processes.private_modules import use_private_modules
from coursekit.processes.session import Session

from .programs import run

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="only where programs are copied by fork")

SQUARES = """
import time

def square(x):
    return x * x

def slowly(queue, lock):
    with lock:
        time.sleep(0.01)
        queue.put([square(7)])
"""


def pool():
    import multiprocessing

    from squares import square

    with multiprocessing.get_context("fork").Pool(2) as workers:
        print(workers.map(square, range(5)), workers.apply_async(square, (9,)).get())


def executor():
    import multiprocessing
    from concurrent.futures import ProcessPoolExecutor

    from squares import square

    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("fork")) as workers:
        print(list(workers.map(square, range(5))), workers.submit(square, 9).result())


def queue():
    import multiprocessing

    from squares import slowly

    fork = multiprocessing.get_context("fork")
    lock, answers = fork.Lock(), fork.Queue()
    children = [fork.Process(target=slowly, args=(answers, lock)) for _ in range(3)]
    for child in children:
        child.start()
    print([answers.get() for _ in children])
    for child in children:
        child.join()
    print([child.exitcode for child in children])


def empty():
    import multiprocessing

    reader, _writer = multiprocessing.get_context("fork").Pipe()
    lock = multiprocessing.get_context("fork").Lock()
    with lock:
        print(reader.poll(), reader.poll(0.05), lock.acquire(timeout=0.05), lock.acquire(False))


SAID = {
    pool: "[0, 1, 4, 9, 16] 81",
    executor: "[0, 1, 4, 9, 16] 81",
    queue: "[[49], [49], [49]]\n[0, 0, 0]",
    empty: "False False False False",
}


@pytest.mark.parametrize("virtual", [True, False], ids=["virtual", "wall"])
@pytest.mark.parametrize("program", SAID, ids=lambda program: program.__name__)
def test_workers_know_the_programs_own_functions(program, virtual, tmp_path):
    (tmp_path / "squares.py").write_text(SQUARES)

    def main():
        use_private_modules(current_process(), [str(tmp_path)])
        program()

    with Session(virtual=virtual).use() as session:
        code, process = run(session, main)
    assert (code, process.output.strip()) == (0, SAID[program]), process.output


def test_others_run_while_a_program_waits_for_a_worker(tmp_path):
    """On the virtual clock all programs share a thread."""
    said = []

    def waits():
        import multiprocessing

        fork = multiprocessing.get_context("fork")
        go, done = fork.Event(), fork.Queue()
        child = fork.Process(target=lambda: done.put(go.wait(30)))
        child.start()
        session.start(lambda: (said.append("another"), go.set()), name="other")
        said.append(done.get())
        child.join()

    with Session(virtual=True).use() as session:
        code, process = run(session, waits)
    assert (code, said) == (0, ["another", True]), process.output
