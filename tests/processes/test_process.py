"""Processes: unmodified main functions side by side, each with its own argv, output, signals and end."""

import os
import subprocess
import sys
import threading
import time

import pytest

from coursekit.processes.process import current_process
from coursekit.processes.session import Session
from coursekit.systems import operating_system
from tests.processes.programs import run


def test_argv_output_and_exit_code_are_the_process_s_own(session):
    before = list(sys.argv)

    def main():
        print(sys.argv)
        print("oops", file=sys.stderr)
        return 3

    code, process = run(session, main, argv=["--fast"])
    assert (code, process.state) == (3, "exited")
    assert process.out.text("stdout") == "['prog', '--fast']\n"
    assert process.out.text("stderr") == "oops\n"
    assert sys.argv == before


@pytest.mark.parametrize(
    ("status", "code", "text"),
    [(None, 0, ""), (0, 0, ""), (7, 7, ""), ("bad luck", 1, "bad luck\n"), (True, 1, "")],
)
def test_sys_exit_gives_the_exit_code_that_python_gives(session, status, code, text):
    got, process = run(session, lambda: sys.exit(status))
    assert (got, process.output) == (code, text)


def test_an_exception_ends_it_with_a_traceback_that_begins_in_the_program(session):
    def main():
        raise ValueError("broken")

    code, process = run(session, main)
    assert code == 1
    assert process.output.startswith("Traceback (most recent call last):\n")
    assert process.output.endswith("ValueError: broken\n")
    assert "core/process.py" not in process.output


def test_input_reads_what_is_typed_and_ends_at_the_end_of_the_text(session):
    def main():
        print("hello " + input("name? "))
        input()

    process = session.start(main, name="asker")
    process.write_stdin("Ada\n")
    process.close_stdin()
    assert process.wait(10) == 1
    assert process.out.text("stdout") == "name? hello Ada\n"
    assert process.output.endswith("EOFError: EOF when reading a line\n")


def test_environment_changes_stay_in_the_process(session):
    def main():
        os.environ["COURSEKIT_TEST"] = "inside"
        print(os.getenv("COURSEKIT_TEST"), os.environ["GIVEN"], "PATH" in os.environ)

    _, process = run(session, main, env={"GIVEN": "yes"})
    assert process.output == "inside yes False\n"
    assert "COURSEKIT_TEST" not in os.environ


def test_the_environment_stays_the_environment_when_it_is_joined_with_others(session):
    def main():
        os.environ |= {"COURSEKIT_TEST": "inside"}
        print(os.getenv("COURSEKIT_TEST"), ({"GIVEN": "no"} | os.environ)["GIVEN"], (os.environ | {"GIVEN": "no"})["GIVEN"])

    there = os.environ
    _, process = run(session, main, env={"GIVEN": "yes"})
    assert process.output == "inside yes no\n"
    assert os.environ is there and "COURSEKIT_TEST" not in os.environ


def test_on_windows_variables_have_no_case(session, monkeypatch):
    monkeypatch.setattr(operating_system, "WINDOWS", True)

    def main():
        os.environ["GIVEN_TOO"] = "also"
        print(*(os.environ[name] for name in ("Given", "GIVEN", "given", "Given_Too")), "gIVEN" in os.environ)
        os.environ.pop("given")
        print("GIVEN" in os.environ)

    _, process = run(session, main, env={"gIven": "yes"})
    assert process.output == "yes yes yes also True\nFalse\n"


def test_children_inherit_what_is_joined_to_the_environment_outside_of_programs(session):
    try:
        os.environ |= {"COURSEKIT_TEST": "outside"}
        command = [sys.executable, "-c", "import os; print(os.environ['COURSEKIT_TEST'])"]
        assert subprocess.run(command, stdout=subprocess.PIPE, encoding="utf-8", check=True).stdout == "outside\n"
    finally:
        os.environ.pop("COURSEKIT_TEST", None)


def test_a_program_s_threads_belong_to_it_and_are_waited_for(session):
    def main():
        def work():
            time.sleep(0.02)
            print("thread of", current_process().name)

        threading.Thread(target=work).start()
        print("main done")

    code, process = run(session, main, name="parent")
    assert (code, process.output) == (0, "main done\nthread of parent\n")


def test_locks_queues_and_events_work_between_a_program_s_threads(session):
    import queue

    def main():
        lock, box, go = threading.Lock(), queue.Queue(), threading.Event()

        def work(name):
            go.wait()
            with lock:
                time.sleep(0.01)
                box.put(name)

        threads = [threading.Thread(target=work, args=(name,)) for name in "abc"]
        for thread in threads:
            thread.start()
        go.set()
        print(sorted(box.get(timeout=5) for _ in threads))
        for thread in threads:
            thread.join()
        print(any(thread.is_alive() for thread in threads))

    code, process = run(session, main)
    assert (code, process.output) == (0, "['a', 'b', 'c']\nFalse\n")


def test_an_error_in_a_thread_is_shown_in_its_process(session):
    def main():
        thread = threading.Thread(target=lambda: 1 / 0, name="worker")
        thread.start()
        thread.join()

    code, process = run(session, main)
    assert code == 0 and "Exception in thread worker" in process.output and "ZeroDivisionError" in process.output


def test_listeners_hear_all_output_and_the_end(session):
    heard, ended = [], []
    process = session.start(lambda: print("x"), name="p", on_output=lambda stream, text: heard.append((stream, text)))
    process.on_exit(lambda one: ended.append(one.exit_code))
    process.wait(10)
    assert "".join(text for _, text in heard) == "x\n" and ended == [0]


def test_output_beyond_the_limit_is_dropped_from_the_front_and_counted():
    with Session(virtual=True).use() as session:

        def main():
            for _ in range(30):
                print("x" * 99_999)

        _, process = run(session, main)
        assert len(process.output) <= 2_000_000 and process.out.dropped == 1_000_000


def test_a_virtual_run_is_the_same_every_time():
    def one():
        with Session(virtual=True).use() as session:
            log = []
            for name in "abc":

                def main(name=name):
                    for index in range(20):
                        time.sleep(0.01 + len(name) * 0.001)
                        print(name, index, time.time())

                session.start(main, name=name, on_output=lambda _, text: log.append(text))
            session.clock.sleep(5)
            return "".join(log)

    assert one() == one()


def test_a_thread_pool_works_in_a_program(session):
    from concurrent.futures import ThreadPoolExecutor

    def main():
        with ThreadPoolExecutor(max_workers=2) as pool:
            print(sorted(pool.map(lambda number: (time.sleep(0.01), number)[1], range(4))))

    code, process = run(session, main)
    assert (code, process.output) == (0, "[0, 1, 2, 3]\n")


def test_waiting_for_a_child_of_the_system_leaves_the_virtual_clock_alone():
    def main():
        child = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(0.3)"])
        print(child.wait(timeout=20))

    with Session(virtual=True).use() as session:
        before = session.clock.steady()
        process = session.start(main, name="waits")
        assert process.wait(1.0) == 0
        assert process.output == "0\n"
        assert session.clock.steady() - before < 1e9


def test_a_process_is_told_the_distribution_as_after_sourcing_ros(session):
    def tell():
        print(os.environ["ROS_DISTRO"], os.environ["ROS_VERSION"], os.environ["ROS_PYTHON_VERSION"])
        assert "LD_LIBRARY_PATH" in os.environ  # a launch file may pass it on

    for env, distribution in ((None, "humble"), ({"ROS_DISTRO": "iron"}, "iron")):
        process = session.start(tell, name="tell", env=env)
        assert process.wait(10) == 0 and process.output == f"{distribution} 2 3\n"
