"""`python -m coursekit.packages.run_test RESULT.xml WORDS... --command COMMAND...`: a test of ctest's that leaves a result.

A result that says that there is none is written first: whatever ends the test, the tests that were not run are counted.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
from pathlib import Path
from xml.sax.saxutils import quoteattr

from coursekit.files import read_text

_LIBRARIES = {"win32": "PATH", "darwin": "DYLD_LIBRARY_PATH"}
"""The environment variable with library paths; elsewhere LD_LIBRARY_PATH."""


def main(words: list[str]) -> int:
    """Run the test; return 0 if its results contain no failure, else the command's exit code, or 1."""
    args = _parsed(words)
    args.result.parent.mkdir(parents=True, exist_ok=True)
    if args.skip_test:
        _write(args, "<skipped/>", skipped=1)
        return 0
    _write(args, _problem("failure", "The test did not leave a result, and may have crashed."), failures=1)
    before = args.result.stat()
    code, output = _run(args)
    print(f"-- run_test: return code {code}", flush=True)
    if args.skip_return_code is not None and code == args.skip_return_code:
        _write(args, "<skipped/>", skipped=1)
    elif _same(args.result, before):
        good = code == 0 and args.generate_result_on_success
        told = "The test did not generate a result file:" + f"\n\n{output}"
        _write(args, "" if good else _problem("error", told), errors=int(not good))
        return code or int(not good)
    else:
        _name_package(args)
    return code


def _parsed(words: list[str]) -> argparse.Namespace:
    """Take the words apart; those of the command are its own, `--` among them."""
    at = words.index("--command") if "--command" in words else len(words)
    args = _parser().parse_args(words[: at + 1])
    args.command = words[at + 1 :]
    return args


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(description=__doc__, allow_abbrev=False)
    parser.add_argument("result", type=Path, help="the file that the command leaves its results in")
    parser.add_argument("--package-name", default="")
    parser.add_argument("--command", nargs="*", required=True)
    parser.add_argument("--output-file", type=Path)
    parser.add_argument("--env", nargs="+", default=[], metavar="NAME=VALUE")
    parser.add_argument("--append-env", nargs="+", default=[], metavar="NAME=PATH")
    parser.add_argument("--append-library-dirs", nargs="+", default=[], metavar="FOLDER")
    parser.add_argument("--generate-result-on-success", action="store_true")
    parser.add_argument("--skip-test", action="store_true")
    parser.add_argument("--skip-return-code", type=int)
    return parser


def _run(args: argparse.Namespace) -> tuple[int, str]:
    """Return the command's exit code and its output, which is also printed as it arrives."""
    print(f"-- run_test: {' '.join(args.command)}", flush=True)
    try:
        started = subprocess.Popen(
            args.command, env=_environment(args), encoding="utf-8", errors="replace",
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        )  # fmt: skip
    except OSError as error:
        print(error, flush=True)
        return 1, f"{error}\n"
    assert started.stdout is not None
    lines = []
    for line in started.stdout:
        print(line, end="", flush=True)
        lines.append(line)
    code, output = started.wait(), "".join(lines)
    if args.output_file:
        args.output_file.parent.mkdir(parents=True, exist_ok=True)
        args.output_file.write_text(output, encoding="utf-8")
    return code, output


def _environment(args: argparse.Namespace) -> dict[str, str]:
    env = {**os.environ, **dict(setting.partition("=")[::2] for setting in args.env)}
    libraries = _LIBRARIES.get(sys.platform, "LD_LIBRARY_PATH")
    more = [setting.partition("=")[::2] for setting in args.append_env] + [
        (libraries, path) for path in args.append_library_dirs
    ]
    for name, value in more:
        env[name] = os.pathsep.join(filter(None, [env.get(name, ""), value]))
    return env


def _same(path: Path, before: os.stat_result) -> bool:
    """Whether the file has not been written since; it may also be gone."""
    if not path.is_file():
        return True
    after = path.stat()
    return (after.st_mtime_ns, after.st_size, after.st_ino) == (before.st_mtime_ns, before.st_size, before.st_ino)


def _name_package(args: argparse.Namespace) -> None:
    """Put the package's name before the class names in results without it, such as gtest's."""
    if not (package := args.package_name):
        return
    text = read_text(args.result, errors="replace")
    lacking = re.compile(rf'(<testcase\b[^<>]*\bclassname=")(?!{re.escape(package)}\.)')
    args.result.write_text(lacking.sub(rf"\g<1>{package}.", text), encoding="utf-8")


def _problem(kind: str, text: str) -> str:
    return f"<{kind} message={quoteattr(text)}/>"


def _write(args: argparse.Namespace, inner: str, *, failures: int = 0, errors: int = 0, skipped: int = 0) -> None:
    """Write a result with a single test as JUnit XML."""
    package, name = quoteattr(args.package_name), quoteattr(f"{args.result.stem}.missing_result")
    counts = f'tests="1" failures="{failures}" errors="{errors}" skipped="{skipped}" time="0.0"'
    args.result.write_text(
        f'<?xml version="1.0" encoding="UTF-8"?>\n<testsuite name={package} {counts}>\n'
        f'  <testcase classname={package} name={name} time="0.0">{inner}</testcase>\n</testsuite>\n',
        encoding="utf-8",
    )


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
