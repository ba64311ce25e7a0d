"""`ros2 doctor`: checks of the set-up and of the graph, and a report."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from coursekit.cli import checks, doctor_hello, graph_report

if TYPE_CHECKING:
    import argparse
    from argparse import Namespace


def register(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the command."""
    add_arguments(subparsers.add_parser("doctor", help="Check ROS setup and other potential issues"))


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and the verb, which `ros2 wtf` has as well."""
    parser.add_argument("-r", "--report", action="store_true", help="Print all reports")
    parser.add_argument("-rf", "--report-failed", action="store_true", help="Print the reports when a check fails")
    parser.add_argument("-iw", "--include-warnings", action="store_true", help="Count warnings as failures")
    parser.set_defaults(main=main)
    doctor_hello.register(parser.add_subparsers(title="Verbs", dest="_verb"))


def main(args: Namespace) -> int:
    """Run the checks, or print the report."""
    if args.report:
        print_report()
        return 0
    results = [*checks.run_all(), graph_report.compatibility(), graph_report.both_ends()]
    bad = [result for result in results if result.fault and (args.include_warnings or not result.only_warning)]
    for result in results:
        _tell(result)
    if not bad:
        print(f"\nAll {len(results)} checks passed\n")
        return 0
    print(f"\n{len(bad)}/{len(results)} check(s) failed\n")
    print("Failed modules:", *(result.name for result in bad))
    if args.report_failed:
        print_report()
    return 0  # as in ROS: a failed check is reported, but is no failure of the command


def _tell(result: checks.Check) -> None:
    """Print a fault as ROS does, and the remedy below it."""
    for line in result.fault.splitlines():
        print(f"UserWarning: {'' if result.only_warning else 'ERROR: '}{line}", file=sys.stderr)
    if result.fault:
        print(f"  {result.cure}", file=sys.stderr)


def print_report() -> None:
    """Print the full report on the set-up and the graph."""
    for title, lines in (*checks.report(), *graph_report.report()):
        print(f"\n   {title}")
        width = _width([key for key, _ in lines])
        for key, value in lines:
            print(f"{key:<{width}}: {value}")


def _width(keys: list[str]) -> int:
    """Return the width of a table's first column, as in ROS: four more than its longest word."""
    longest = max(map(len, keys), default=0)
    return longest + 4 if longest >= 8 else 8
