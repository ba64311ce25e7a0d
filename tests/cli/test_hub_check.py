"""`coursekit hub-check` measures what a student costs a server, and says what is missing for a class."""

import os

import pytest

from coursekit.cli import hub_check, hub_load
from coursekit.cli.coursekit import main
from coursekit.grade import exchange

LOAD = hub_load.Load(server_mb=100, kernel_mb=80, busy_mb=300, cores=0.5, server_s=2.5, kernel_s=1.5)


@pytest.fixture
def server(tmp_path, monkeypatch):
    """A server with 8 GB and four cores, on which nothing was prepared."""
    for name in (hub_check.SHARED, exchange.VARIABLE):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr("psutil.virtual_memory", lambda: type("Memory", (), {"total": 8192 * hub_load.MB}))
    monkeypatch.setattr("os.cpu_count", lambda: 4)
    monkeypatch.setattr(hub_load, "measure", lambda: LOAD)
    return tmp_path


def by_name(checks):
    return {check.name: check for check in checks}


def test_students_that_fit_are_no_fault_and_more_are(server):
    fits = by_name(hub_check.load(16))["memory"]
    assert fits.finding == "400 MB a student with a simulation (100 server, 80 to 300 kernel): 16 fit into 8 GB"
    assert not fits.fault
    assert by_name(hub_check.load(17))["memory"].fault == "17 students need 8 GB"


def test_the_processor_s_share_says_how_many_simulate_at_full_speed(server):
    assert "4 carry 8 at full speed" in by_name(hub_check.load(0))["processor"].finding


def test_a_server_that_cannot_start_is_a_fault_with_a_cure(server, monkeypatch):
    def fail():
        raise hub_load.NotMeasured("the Jupyter server does not start")

    monkeypatch.setattr(hub_load, "measure", fail)
    (only,) = hub_check.load(3)
    assert only.fault == "the Jupyter server does not start"
    assert only.cure == "Run: coursekit doctor"


def test_what_is_not_compiled_ahead_is_a_warning_that_says_the_command(server, monkeypatch):
    assert "sudo coursekit hub-prepare /srv/coursekit" in hub_check.compiled_ahead().cure
    monkeypatch.setenv(hub_check.SHARED, str(server))
    assert "not compiled for this version: SLAM" in hub_check.compiled_ahead().fault
    assert hub_check.compiled_ahead().only_warning


@pytest.mark.skipif(os.name == "nt", reason="rights as on Linux")
@pytest.mark.parametrize(
    ("rights", "fault"),
    [(0o2733, ""), (0o2777, "students can see what others handed in"), (0o2700, "students can hand nothing in")],
)
def test_the_exchange_s_rights_are_looked_at(server, monkeypatch, rights, fault):
    monkeypatch.setenv(exchange.VARIABLE, str(server))
    assert "no folder outbound and no inbound" in hub_check.exchange_folder().fault
    for name in (exchange.OUTBOUND, exchange.INBOUND):
        (server / name).mkdir()
    (server / exchange.INBOUND).chmod(rights)
    assert hub_check.exchange_folder().fault == fault


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="the server listens on a Unix socket")
def test_a_student_with_a_simulation_is_measured_and_nothing_is_left(capsys):
    load = hub_load.measure()
    assert 20 < load.server_mb < 500
    assert 20 < load.kernel_mb < load.busy_mb < 2000
    assert 0 < load.cores < 2
    assert load.server_s > 0
    assert load.kernel_s > 0
    assert not [
        child for child in hub_load.psutil.Process().children(recursive=True) if "ck-hub-" in " ".join(child.cmdline())
    ]


def test_the_command_says_all_and_its_exit_code_is_that_of_the_faults(server, capsys):
    faults = [check.fault for check in (hub_check.hub_package(), *hub_check.load(10)) if check.fault]
    assert main(["hub-check", "--students", "10"]) == (1 if faults else 0)
    assert main(["hub-check", "--students", "1000"]) == 1
    said = capsys.readouterr().out
    assert "✘ memory      1000 students need" in said
    assert "→ Take a larger server" in said
