"""The commands `check_urdf`, `urdf_to_graphviz` and `xacro`."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from coursekit.systems.streams import use_utf8
from coursekit.urdf import Robot, UrdfError, load, parse
from coursekit.urdf.inertia import check
from coursekit.urdf.texts import check_text, error_text, graphviz_text

FAILED = 255
"""The exit code of the real commands: -1 as seen by a shell."""


def _read(path: str) -> Robot | None:
    """Read the robot of a file, or of standard input ("-"); None after printing an error."""
    try:
        return parse(sys.stdin.read(), "standard input") if path == "-" else load(path)
    except UrdfError as error:
        print(error_text(error), end="", file=sys.stderr)
        print("ERROR: Model Parsing the xml failed", file=sys.stderr)
        return None


def check_urdf(argv: Sequence[str] | None = None) -> int:
    """Run `check_urdf FILE`: print the tree of links, or the error and its position."""
    use_utf8()
    words = list(sys.argv[1:] if argv is None else argv)
    if not words:
        print("Expect URDF xml file to parse. Use - for stdin", file=sys.stderr)
        return FAILED
    robot = _read(words[0])
    if robot is None:
        return FAILED
    for fault in robot.faults:
        print(error_text(fault), end="", file=sys.stderr)
    for warning in (*robot.warnings, *check(robot)):
        print(f"Warning: {warning}", file=sys.stderr)
    print(check_text(robot), end="")
    return 0


def urdf_to_graphviz(argv: Sequence[str] | None = None) -> int:
    """Run `urdf_to_graphviz FILE [OUTPUT]`: write the tree as OUTPUT.gv (Graphviz text) and OUTPUT.pdf (picture)."""
    use_utf8()
    words = list(sys.argv[1:] if argv is None else argv)
    if not 1 <= len(words) <= 2:
        usage = "Will create either $ROBOT_NAME.gv & $ROBOT_NAME.pdf in CWD  or OUTPUT.gv & OUTPUT.pdf."
        print(f"Usage: urdf_to_graphviz input.xml [OUTPUT]  {usage}", file=sys.stderr)
        return FAILED
    robot = _read(words[0])
    if robot is None:
        return FAILED
    output = words[1] if len(words) > 1 else robot.name
    Path(f"{output}.gv").write_text(graphviz_text(robot), encoding="utf-8")
    print(f"Created file {output}.gv")
    if _write_pdf(robot, Path(f"{output}.pdf")):
        print(f"Created file {output}.pdf")
    return 0


def _write_pdf(robot: Robot, path: Path) -> bool:
    import io

    import matplotlib.image
    from matplotlib.backends.backend_pdf import FigureCanvasPdf
    from matplotlib.figure import Figure

    from coursekit.view.robot_tree import RobotTree

    image = matplotlib.image.imread(io.BytesIO(RobotTree(robot).png()))
    figure = Figure(figsize=(image.shape[1] / 200, image.shape[0] / 200), dpi=200)
    FigureCanvasPdf(figure)
    figure.figimage(image)
    figure.savefig(path, metadata={"CreationDate": None})
    return True


def xacro(argv: Sequence[str] | None = None) -> int:
    """Run `xacro FILE name:=value ...`: print the file as URDF."""
    import xacro as tool

    words = list(sys.argv[1:] if argv is None else argv)
    before = sys.argv
    try:
        sys.argv = ["xacro", *words]
        tool.main()
    finally:
        sys.argv = before
    return 0
