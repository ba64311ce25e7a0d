"""Run the conformance tests on coursekit and on the real rclpy, and print a table of both."""

from __future__ import annotations

import os
import platform
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parent.parent
REAL_ENVIRONMENT = ROOT / ".venv-ros"
REQUIREMENTS = HERE / "requirements-ros.txt"

sys.path.insert(0, str(HERE))  # also where this file was loaded by its path

from loopback import alone  # noqa: E402

Results = dict[str, str]
"""'passed', 'failed' or 'skipped' by test id."""

BAD = {"failure", "error"}
"""The tags of pytest's report for a test that failed."""

STACKS_S, LONGEST_S = 100, 900
"""When a test that hangs tells its stacks, and when its interpreter is ended [s]; the suite takes half a minute."""


def why_not_real() -> str:
    """Why the real rclpy cannot be asked on this machine; empty when it can."""
    version_fits = (3, 10) <= sys.version_info[:2] <= (3, 14)
    if sys.platform != "linux" or platform.machine() != "x86_64" or not version_fits:
        return "its wheels exist for Linux x86-64 with Python 3.10 to 3.14 only"
    return "" if alone(["true"]) else "it listens on all networks, and here nothing keeps it on loopback (unshare -n)"


def real_python() -> Path:
    """Return the interpreter that has the real rclpy; make its environment when it is not there."""
    python = REAL_ENVIRONMENT / "bin" / "python"
    done = REAL_ENVIRONMENT / ".installed"
    wanted = REQUIREMENTS.read_text()
    if not done.exists() or done.read_text() != wanted:
        print(f"installing the real rclpy into {REAL_ENVIRONMENT.name} ...", flush=True)
        subprocess.run([sys.executable, "-m", "venv", str(REAL_ENVIRONMENT)], check=True)
        install = [
            str(python),
            "-m",
            "pip",
            "install",
            "-q",
            "--disable-pip-version-check",
            "-r",
            str(REQUIREMENTS),
        ]
        subprocess.run(install, check=True)
        done.write_text(wanted)
    return python


def run(python: Path | str) -> Results:
    """Run the suite with an interpreter and return the outcome of every test."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.xml"
        options = ["-q", "-o", "addopts=", "-p", "no:cacheprovider", "-W", "ignore", f"--junitxml={report}"]
        options += ["--confcutdir", str(HERE)]  # the real rclpy's environment has nothing for other tests
        options += ["-o", f"faulthandler_timeout={STACKS_S}"]
        command = [str(python), "-m", "pytest", str(HERE), *options]
        command = command if python == sys.executable else alone(command) or command
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        subprocess.run(command, cwd=folder, env=environment, stdout=subprocess.DEVNULL, check=False, timeout=LONGEST_S)
        if not report.exists():
            raise SystemExit(f"{python} could not run pytest; try: {' '.join(command)}")
        xml = report.read_text()
        for failure in failures(xml):
            print(failure, file=sys.stderr)
        return outcomes(xml)


def outcomes(report: str) -> Results:
    """Read pytest's report.

    >>> outcomes('<t><testcase classname="m.test_a" name="b"/></t>')
    {'test_a::b': 'passed'}
    """
    result_by_case: Results = {}
    for case in ElementTree.fromstring(report).iter("testcase"):
        kinds = {child.tag for child in case}
        bad = kinds & BAD
        module = case.get("classname", "").rpartition(".")[2]
        result_by_case[f"{module}::{case.get('name')}"] = (
            "failed" if bad else "skipped" if "skipped" in kinds else "passed"
        )
    return result_by_case


def failures(report: str) -> list[str]:
    """Return what pytest said about each test that failed.

    >>> failures('<t><testcase classname="m.test_a" name="b"><failure>assert 0</failure></testcase></t>')
    ['m.test_a::b failed:\\nassert 0']
    """
    cases = ElementTree.fromstring(report).iter("testcase")
    said = [(case, child) for case in cases for child in case if child.tag in BAD]
    return [f"{case.get('classname')}::{case.get('name')} failed:\n{child.text}" for case, child in said]


def table(ours: Results, real: Results | None) -> list[str]:
    """Return the lines of the comparison, totals last."""
    names = sorted(ours.keys() | (real or {}).keys())
    width = max((len(name) for name in names), default=4)
    lines = [f"{'test':{width}}  {'coursekit':9}  real rclpy"]
    for name in names:
        beside = "-" if real is None else real.get(name, "-")
        lines.append(f"{name:{width}}  {ours.get(name, '-'):9}  {beside}")
    lines += ["", total("coursekit", ours)]
    return lines if real is None else [*lines, total("real rclpy", real)]


def total(who: str, results: Results) -> str:
    """Return one line that counts.

    >>> total("coursekit", {"a": "passed", "b": "skipped"})
    'coursekit: 2 tests, 1 passed, 0 failed, 1 skipped'
    """
    counts = [f"{list(results.values()).count(kind)} {kind}" for kind in ("passed", "failed", "skipped")]
    return f"{who}: {len(results)} tests, {', '.join(counts)}"


def main() -> int:
    """Print the table; 1 when a test fails on either side."""
    ours = run(sys.executable)
    why_not = why_not_real()
    real = None if why_not else run(real_python())
    print("\n".join(table(ours, real)))
    if real is None:
        print(f"THE REAL RCLPY WAS NOT ASKED: {why_not}")
    return int("failed" in ours.values() or "failed" in (real or {}).values())
