"""A YAML file of parameters becomes a Python module: structs of their values, and a listener that keeps them up to date."""

from __future__ import annotations

import keyword
import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from coursekit.cpp.parameter_library import Parameter, ParameterFileError, Struct, read_parameters

from .python_validators import ParameterValidators

_MODULE = '''\
"""Made from {file} by generate_parameter_module(): what is changed here is lost."""

# flake8: noqa
from generate_parameter_library_py._parameter_listener import Described, ParameterListener, ParameterSet, ParameterStruct
from generate_parameter_library_py.python_validators import ParameterValidators
from rclpy.parameter import Parameter
{imports}

{structs}
DESCRIBED = (
{described}
)


class {name}:
    """The parameters of {name}."""

    class Params(_Params):
        """Their values."""

    class ParamListener(ParameterListener):
        """Declares them on a node, and keeps their values up to date."""

        def __init__(self, node, prefix=""):
            super().__init__(node, {name}.Params(), DESCRIBED, {text}, prefix)
'''
_STRUCT = """\
class {name}({base}):
    def __init__(self):
        super().__init__()
{fields}
"""
_TYPES = {
    "bool": "BOOL", "int": "INTEGER", "double": "DOUBLE", "string": "STRING",
    "bool_array": "BOOL_ARRAY", "int_array": "INTEGER_ARRAY", "double_array": "DOUBLE_ARRAY", "string_array": "STRING_ARRAY",
}  # fmt: skip
_CHECKS = {name for name in vars(ParameterValidators) if not name.startswith("_")}
_CHECK = re.compile(r"[A-Za-z_]\w*(::[A-Za-z_]\w*)*(<>)?")
_LARGEST = 2**31 - 1
"""The range that descriptors tell of an integer without a limit, as upstream's."""


def run(output_file: str, yaml_file: str, validation_module: str = "") -> None:
    """Write a module; SystemExit says what is wrong with the YAML file."""
    try:
        text = python_module(read_parameters(Path(yaml_file)), Path(yaml_file).name, validation_module)
    except (ParameterFileError, OSError) as error:
        raise SystemExit(f"ERROR: {yaml_file}: {error}") from error
    Path(output_file).parent.mkdir(parents=True, exist_ok=True)
    Path(output_file).write_text(text, encoding="utf-8")


def python_module(root: Struct, file: str = "a YAML file", validation_module: str = "") -> str:
    """Return the module's text; `validation_module` has the file's own checks."""
    for part in validation_module.split(".") if validation_module else ():
        _checked(part)
    return _MODULE.format(
        file=re.sub(r"[^\w. -]", "_", file),
        imports=f"\nimport {validation_module} as custom_validators\n" if validation_module else "",
        structs="\n\n".join(_structs([root], "_Params", "ParameterSet")) + "\n",
        described="\n".join(_described(root, [], [], root)),
        name=_checked(root.name),
        text=repr(root.name),
    )


def _checked(name: str) -> str:
    """Return a name of something in the module; ParameterFileError if it cannot be one."""
    if not name.isidentifier() or keyword.iskeyword(name) or name.startswith("__"):
        raise ParameterFileError(f"{name!r} cannot be a name in Python: it has letters, digits and underscores")
    return name


# -- the structs


def _structs(alike: list[Struct], name: str, base: str = "ParameterStruct") -> Iterator[str]:
    """Yield the class of structs that share a name, after those of what they hold: a struct's entries are of one class."""
    fields = [f"        self.{_checked(p.name)} = {_value(p.default)}" for struct in alike for p in struct.parameters]
    below = [inner for struct in alike for inner in struct.structs]
    for inner in below:
        if not inner.mapped:
            yield from _structs([inner], f"{name}_{_checked(inner.name)}")
            fields.append(f"        self.{inner.name} = {name}_{inner.name}()")
    if entries := [inner for inner in below if inner.mapped]:
        yield from _structs(entries, f"{name}_Entry")
        fields.append(f"        self.Entry = {name}_Entry")
    yield _STRUCT.format(name=name, base=base, fields="\n".join(fields)).rstrip() + "\n"


def _value(value: Any) -> str:
    """Return a value as Python writes it.

    >>> _value([1.0, float("nan")]), _value("it's"), _value(None)
    ("[1.0, float('nan')]", '"it\\'s"', 'None')
    """
    if isinstance(value, list):
        return f"[{', '.join(map(_value, value))}]"
    if isinstance(value, float) and not math.isfinite(value):
        return f"float({str(value)!r})"
    return repr(value)


# -- what is said of each parameter


def _described(struct: Struct, words: list[str], maps: list[str], root: Struct) -> Iterator[str]:
    for parameter in struct.parameters:
        given = {
            "description": parameter.description, "read_only": parameter.read_only,
            "additional_constraints": parameter.additional_constraints,
        }  # fmt: skip
        parts = [repr((*words, parameter.name)), _default(parameter)]
        parts += [f"{key}={value!r}" for key, value in given.items() if value]
        parts += [f"limits={_limits(parameter)}"] * bool(parameter.limits)
        parts += [f"checks=({' '.join(_check(*check) + ',' for check in parameter.checks)})"] * bool(parameter.checks)
        parts += [f"maps={tuple(maps)!r}"] * bool(maps)
        yield f"    Described({', '.join(parts)}),"
    for inner in struct.structs:
        names = [_names_of_entries(inner, struct, words, root)] * bool(inner.mapped)
        yield from _described(inner, [*words, inner.name], maps + names, root)


def _names_of_entries(entries: Struct, beside: Struct, words: list[str], root: Struct) -> str:
    """Return the parameter that names them: one of the file, or one that stands beside them."""
    name = entries.mapped
    known = {parameter.name for parameter in root.parameters}
    if "." not in name and name not in known and name in {parameter.name for parameter in beside.parameters}:
        return ".".join([*words, name])
    return name


def _default(parameter: Parameter) -> str:
    return f"Parameter.Type.{_TYPES[parameter.kind]}" if parameter.default is None else _value(parameter.default)


def _limits(parameter: Parameter) -> str:
    lower, upper = (parameter.limits.get(end) for end in (0, 1))
    if parameter.kind == "double":
        return _pair(-math.inf if lower is None else float(lower), math.inf if upper is None else float(upper))
    return _pair(-_LARGEST - 1 if lower is None else lower, _LARGEST if upper is None else upper)


def _pair(lower: float, upper: float) -> str:
    return f"({_value(lower)}, {_value(upper)})"


def _check(name: str, given: list[Any]) -> str:
    """Return a function of a parameter.

    >>> _check("gt<>", [0.0]), _check("custom_validators::is_odd", [])
    ('lambda param: ParameterValidators.gt(param, 0.0)', 'lambda param: custom_validators.is_odd(param)')
    """
    if not _CHECK.fullmatch(name):
        raise ParameterFileError(f"{name!r} cannot be the name of a check")
    path = name.removesuffix("<>").replace("::", ".")
    if "." not in path and path not in _CHECKS:
        raise ParameterFileError(f"there is no check {path!r} in Python; there are: {', '.join(sorted(_CHECKS))}")
    called = path if "." in path else f"ParameterValidators.{path}"
    return f"lambda param: {called}({', '.join(['param', *map(_value, given)])})"
