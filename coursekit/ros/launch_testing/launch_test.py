"""The command `launch_test`: runs the launch tests of a file."""

from __future__ import annotations

import argparse
import importlib.util
import logging
import os
import sys
from collections.abc import Sequence
from importlib.machinery import SourceFileLoader
from types import ModuleType

from coursekit.systems.streams import use_utf8

from .junitxml import unittestResultsToXml
from .loader import LoadTestsFromPythonModule
from .print_arguments import print_arguments_of_launch_description
from .test_runner import LaunchTestRunner

_logger = logging.getLogger(__name__)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the command's arguments."""
    parser.add_argument("launch_test_file", help="Path to the launch test.")
    parser.add_argument("--package-name", help="Name of the package the test is in. Useful to aggregate xUnit reports.")
    parser.add_argument("-v", "--verbose", action="store_true", help="Run with verbose output")
    parser.add_argument(
        "-s",
        "--show-args",
        "--show-arguments",
        action="store_true",
        help="Show arguments that may be given to the launch test.",
    )
    parser.add_argument(
        "launch_arguments",
        nargs="*",
        help="Arguments in '<name>:=<value>' format (for duplicates, last one wins).",
    )
    parser.add_argument("--junit-xml", dest="xmlpath", help="Do write xUnit reports to specified path.")


def parse_arguments(
    argv: Sequence[str] | None = None,
) -> tuple[argparse.ArgumentParser, argparse.Namespace]:
    """Return the command's parser and the arguments parsed from `argv` (sys.argv by default)."""
    parser = argparse.ArgumentParser(description="Launch integration testing tool.")
    add_arguments(parser)
    return parser, parser.parse_args(argv)


def run(
    parser: argparse.ArgumentParser,
    args: argparse.Namespace,
    test_runner_cls: type[LaunchTestRunner] = LaunchTestRunner,
) -> int | None:
    """Run the command; return its exit code."""
    if not os.path.isfile(args.launch_test_file):
        parser.error(f"Test file '{args.launch_test_file}' does not exist")
    path = os.path.abspath(args.launch_test_file)
    name = os.path.splitext(os.path.basename(path))[0]
    package = args.package_name or name
    _logger.debug(f"Loading tests from file '{path}'")
    runs = LoadTestsFromPythonModule(_load(package, path), name=f"{package}.{name}.launch_tests")
    runner = test_runner_cls(runs, args.launch_arguments, args.verbose)
    runner.validate()
    if args.show_args:
        print_arguments_of_launch_description(launch_description=runs[0].get_launch_description())
        return None
    _logger.debug("Running integration test")
    results = runner.run()
    _logger.debug("Done running integration test")
    if args.xmlpath:
        report = unittestResultsToXml(name=f"{package}.{name}", test_results=results)
        report.write(args.xmlpath, encoding="utf-8", xml_declaration=True)
    return 0 if all(result.wasSuccessful() for result in results.values()) else 1


def _load(name: str, path: str) -> ModuleType:
    """Load the file as a module, which others cannot import: it is named after its package."""
    loader = SourceFileLoader(name, path)
    spec = importlib.util.spec_from_loader(name, loader)
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    loader.exec_module(module)
    return module


def main() -> None:
    """Entry point of the shell command."""
    use_utf8()
    logging.basicConfig()
    parser, args = parse_arguments()
    if args.verbose:
        _logger.setLevel(logging.DEBUG)
        _logger.debug("Running with verbose output")
    try:
        code = run(parser, args)
    except Exception as error:
        parser.error(str(error))
    sys.exit(code)


if __name__ == "__main__":
    main()
