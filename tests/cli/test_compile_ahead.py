"""`coursekit lab` has SLAM compiled while the student reads, without waiting for it."""

import subprocess

from coursekit.cli import compile_ahead
from coursekit.systems.children import apart


def test_it_is_started_in_a_session_of_its_own_and_nobody_waits(monkeypatch):
    begun = []
    monkeypatch.setattr(subprocess, "Popen", lambda command, **how: begun.append((command, how)))
    compile_ahead.start_in_background({"A": "b"})
    ((command, how),) = begun
    assert command[1:] == ["-m", "coursekit.cli.compile_ahead"] and how["env"] == {"A": "b"}
    assert apart().items() <= how.items() and how["stdout"] == subprocess.DEVNULL


def test_where_no_process_can_be_started_the_lab_opens_all_the_same(monkeypatch):
    def refuse(*_command, **_how):
        raise OSError("no more processes")

    monkeypatch.setattr(subprocess, "Popen", refuse)
    compile_ahead.start_in_background({})


def test_it_compiles_what_slam_and_the_simulator_compile(monkeypatch):
    from coursekit.nodes.gazebo import precompile as simulator
    from coursekit.slam import precompile as slam

    used = []
    monkeypatch.setattr(compile_ahead.os, "nice", used.append, raising=False)
    monkeypatch.setattr(slam, "warm", lambda: used.append("slam"))
    monkeypatch.setattr(simulator, "warm_up", lambda: used.append("simulator"))
    assert compile_ahead.main() == 0 and used == [19, "slam", "simulator"]
