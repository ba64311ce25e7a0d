"""The program run by generate_parameter_library() and generate_parameter_module() in a CMakeLists.txt.

`python -m coursekit.packages.generate_parameters OUTPUT FILE [CHECKS]` writes the C++ header of a YAML file of parameters,
or its Python module if OUTPUT is one.
"""

from __future__ import annotations

import sys
from pathlib import Path

from generate_parameter_library_py.generate_python_module import python_module

from coursekit.cpp.parameter_header import parameter_header
from coursekit.cpp.parameter_library import ParameterFileError, read_parameters


def main(words: list[str]) -> int:
    """Run a command line; return the exit code."""
    output, file, *checks = words
    try:
        root = read_parameters(Path(file))
        text = python_module(root, Path(file).name, *checks) if output.endswith(".py") else parameter_header(root, *checks)
    except (ParameterFileError, OSError) as error:
        print(f"ERROR: {error}", file=sys.stderr)
        return 1
    Path(output).parent.mkdir(parents=True, exist_ok=True)
    Path(output).write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
