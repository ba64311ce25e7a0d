"""The program run by generate_parameter_library() in a CMakeLists.txt.

`python -m coursekit.packages.generate_parameters HEADER FILE [CHECKS]` writes the C++ header of a YAML file of parameters.
"""

from __future__ import annotations

import sys
from pathlib import Path

from coursekit.cpp.parameter_header import parameter_header
from coursekit.cpp.parameter_library import ParameterFileError, read_parameters


def main(words: list[str]) -> int:
    """Run a command line; return the exit code."""
    header, file, *checks = words
    try:
        text = parameter_header(read_parameters(Path(file)), *checks)
    except (ParameterFileError, OSError) as error:
        print(f"ERROR: {error}", file=sys.stderr)
        return 1
    Path(header).parent.mkdir(parents=True, exist_ok=True)
    Path(header).write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
