"""The YAML files of generate_parameter_library: structs of parameters with types, defaults and what is valid."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from coursekit.files import read_text

TYPES = {
    "none": None, "bool": "bool", "double": "double", "int": "int64_t", "string": "std::string",
    "bool_array": "std::vector<bool>", "double_array": "std::vector<double>", "int_array": "std::vector<int64_t>",
    "string_array": "std::vector<std::string>",
}  # fmt: skip
"""The types of parameters, and those of their fields."""
FIXED = {"double_array", "int_array", "bool_array", "string"}
"""Those of which _fixed_N has room for N."""
_KEYS = {"type", "default_value", "description", "read_only", "validation", "additional_constraints"}
_NAME = re.compile(r"[A-Za-z_]\w*([.]\w+|::\w+)*")
_NAMES = {bool: "bool", float: "double", int: "int", str: "string"}
_LIMITS = {
    "bounds": (0, 1), "lower_bounds": (0, None), "gt": (0, None), "gt_eq": (0, None),
    "upper_bounds": (None, 0), "lt": (None, 0), "lt_eq": (None, 0),
}  # fmt: skip
"""The checks that descriptors tell as ranges: which of their arguments is the lower limit, and which the upper."""


class ParameterFileError(Exception):
    """What is wrong with a file."""


@dataclass
class Parameter:
    """One parameter, or one for each value of other parameters."""

    name: str
    path: str
    kind: str
    size: int = 0
    default: Any = None
    description: str = ""
    read_only: bool = False
    additional_constraints: str = ""
    checks: list[tuple[str, list[Any]]] = field(default_factory=list)

    @property
    def base(self) -> str:
        """The C++ type of its value, or of its elements."""
        return str(TYPES[self.kind.removesuffix("_array")])

    @property
    def limits(self) -> dict[int, float]:
        """What a number may not be below (0) and above (1), as far as its checks say it."""
        if self.kind not in ("int", "double"):
            return {}
        return {
            end: given[at]
            for name, given in self.checks
            for end, at in enumerate(_LIMITS.get(name.removesuffix("<>"), ()))
            if at is not None and at < len(given) and isinstance(given[at], (int, float))
        }


@dataclass
class Struct:
    """The parameters below a name; below __map_NAME there are some for each value of the parameter NAME."""

    name: str
    parameters: list[Parameter] = field(default_factory=list)
    structs: list[Struct] = field(default_factory=list)

    @property
    def mapped(self) -> str:
        """The parameter with the names, or ''."""
        return self.name.removeprefix("__map_") if self.name.startswith("__map_") else ""


def read_parameters(path: Path) -> Struct:
    """Read a file; ParameterFileError if it is not as generate_parameter_library wants it."""
    try:
        document = yaml.safe_load(read_text(path))
        if not isinstance(document, dict) or len(document) != 1:
            raise ParameterFileError("The yaml definition must only have one root element")
        (name, tree), = document.items()  # fmt: skip
        return _struct(_checked(name), tree, [])
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        raise ParameterFileError(str(error)) from error


def _checked(name: Any) -> str:
    if not isinstance(name, str) or not _NAME.fullmatch(name):
        raise ParameterFileError(f"{name!r} cannot be a name in C++: it has letters, digits and underscores")
    return name


def _struct(name: str, tree: dict[str, Any], above: list[str]) -> Struct:
    struct = Struct(name)
    if not isinstance(tree, dict):
        raise ParameterFileError(f"No type defined for parameter {'.'.join(above) or name}")
    for key, value in tree.items():
        _checked(key)
        if not isinstance(value, dict):
            raise ParameterFileError(f"No type defined for parameter {'.'.join(above)}")
        if any(isinstance(entry, dict) for word, entry in value.items() if word != "validation" or not _is_leaf(value)):
            struct.structs.append(_struct(key, value, [*above, key]))
        elif parameter := _parameter(key, value, [*above, key]):
            struct.parameters.append(parameter)
    return struct


def _is_leaf(value: dict[str, Any]) -> bool:
    return isinstance(value.get("type"), str)


def _parameter(name: str, value: dict[str, Any], names: list[str]) -> Parameter | None:
    path = ".".join(names)
    if "type" not in value:
        raise ParameterFileError(f"No type defined for parameter {path}")
    for key in value.keys() - _KEYS:
        raise ParameterFileError(f"Invalid syntax in parameter {path}. '{key}' is not valid syntax")
    kind, size = _kind(str(value["type"]), path)
    if kind == "none":
        return None
    default = value.get("default_value")
    _check_default(path, kind, default)
    checks = _checks(path, value.get("validation") or {})
    if size:
        checks.append(("size_lt<>", [size + 1]))
    told = str(value.get("description") or "")
    more = str(value.get("additional_constraints") or "")
    return Parameter(name, path, kind, size, default, told, bool(value.get("read_only")), more, checks)


def _kind(written: str, path: str) -> tuple[str, int]:
    if (fixed := re.fullmatch(r"(\w+)_fixed_(\d+)", written)) and fixed[1] in FIXED:
        return fixed[1], int(fixed[2])
    if written not in TYPES:
        raise ParameterFileError(
            f"Invalid parameter type `{written}` for parameter {path}. Allowed types are: {', '.join(TYPES)}"
        )
    return written, 0


def _check_default(path: str, kind: str, default: Any) -> None:
    wanted = kind.removesuffix("_array")
    values = default if isinstance(default, list) and kind.endswith("_array") else [default]
    for value in values:
        if default is not None and _NAMES.get(type(value)) != wanted:
            got = _NAMES.get(type(value), type(value).__name__)
            raise ParameterFileError(f"Parameter {path} has incorrect type. Expected: {kind}, got: {got}")


def _checks(path: str, validation: Any) -> list[tuple[str, list[Any]]]:
    if not isinstance(validation, dict):
        raise ParameterFileError(f"Invalid syntax in parameter {path}. 'validation' has to name checks")
    checks = [(str(name), _arguments(given)) for name, given in validation.items()]
    for name, given in checks:
        flat = [item for value in given for item in (value if isinstance(value, list) else [value])]
        if wrong := [item for item in flat if type(item) not in _NAMES]:
            raise ParameterFileError(f"Invalid syntax in parameter {path}. {name} cannot be given {wrong[0]!r}")
    return checks


def _arguments(given: Any) -> list[Any]:
    return [] if given is None else given if isinstance(given, list) else [given]
