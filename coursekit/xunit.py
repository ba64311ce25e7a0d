"""Linter results as files for `colcon test-result`, in the format of ament's linters."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from xml.sax.saxutils import escape, quoteattr


def write_results(
    path: str | Path, cases: Sequence[tuple[str, str]], checked: Sequence[str], seconds: float, skipped: str = ""
) -> None:
    """Write a results file: each case is a name and a message, '' for success; `skipped` is why nothing was checked.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     write_results(file := Path(folder, "flake8.xunit.xml"), [("E302 (./a.py:3:1)", "2 lines")], ["./a.py"], 0.1)
    ...     '<failure message="2 lines"/>' in file.read_text()
    True
    """
    path = Path(path)
    cases = [("skipped", "")] if skipped else cases
    whole = quoteattr(f"{path.absolute().parent.name}.{path.name.removesuffix('.xml').removesuffix('.xunit')}")
    failures = sum(1 for _, why in cases if why)
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f"<testsuite\n  name={whole}\n  tests=\"{len(cases)}\"\n  errors=\"0\"\n  failures=\"{failures}\"",
        *([f'  skipped="{len(cases)}"'] if skipped else []),
        f'  time="{seconds:.3f}"\n>',
        *(_case(name, whole, why, skipped) for name, why in cases),
        "  <system-out>Checked files:" + escape("".join(f"\n* {path}" for path in checked)) + "</system-out>",
        "</testsuite>\n",
    ]
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines), encoding="utf-8")


def _case(name: str, whole: str, why: str, skipped: str) -> str:
    head = f"  <testcase\n    name={quoteattr(name)}\n    classname={whole}"
    if not (why or skipped):
        return f"{head}/>"
    told = f"<failure message={quoteattr(why)}/>" if why else f"<skipped message={quoteattr(skipped)}/>"
    return f"{head}\n  >\n      {told}\n  </testcase>"
