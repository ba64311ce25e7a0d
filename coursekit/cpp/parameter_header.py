"""The C++ header of a file of parameters: the structs with their values, and the listener that keeps them up to date."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from typing import Any

from coursekit.cpp.parameter_library import TYPES, Parameter, Struct

_HEADER = """\
// Made from a file of parameters by generate_parameter_library(): what is changed here is lost.
#pragma once
#include "generate_parameter_library/coursekit_listener.hpp"
{includes}
namespace {space}
{{
using namespace rsl;  // NOLINT

struct Params
{{
{fields}
  rclcpp::Time __stamp;
}};

struct StackParams
{{
{stack_fields}
}};

struct ParamLayout
{{
  template<class F>
  static void fixed([[maybe_unused]] Params & params, [[maybe_unused]] F && each)
  {{
{fixed}
  }}
  template<class F>
  static void mapped([[maybe_unused]] Params & params, [[maybe_unused]] F && each)
  {{
{mapped}
  }}
  static void forget([[maybe_unused]] Params & params)
  {{
{forget}
  }}
  static void stack([[maybe_unused]] const Params & params, [[maybe_unused]] StackParams & out)
  {{
{stack}
  }}
}};

class ParamListener : public coursekit::ParameterListener<Params, StackParams, ParamLayout>
{{
public:
  using coursekit::ParameterListener<Params, StackParams, ParamLayout>::ParameterListener;
}};
}}  // namespace {space}
"""
_EACH = """    each({name}, {field}, {has_default}, {descriptor},
      [](const rclcpp::Parameter & {param}) -> Result {{
{checks}        return {{}};
      }});"""
_CHECK = """        if (auto result = {call}; !result) {{
          return result;
        }}
"""


def parameter_header(root: Struct, include: str = "") -> str:
    """Return the header's text; `include` is the header with the file's own checks."""
    texts = {
        "includes": f'#include "{include}"\n' if include else "",
        "space": root.name,
        "fields": "\n".join(_fields(root, "  ", False)),
        "stack_fields": "\n".join(_fields(root, "  ", True)),
        "fixed": "\n".join(_each(root, "params", "", mapped=False)),
        "mapped": "\n".join(_each(root, "params", "", mapped=True)),
        "forget": "\n".join(_forget(root, "params")),
        "stack": "\n".join(f"    out.{name} = params.{name};" for name in _on_stack(root, "")),
    }
    return _HEADER.format(**texts)


# -- the structs


def _fields(struct: Struct, indent: str, stack: bool) -> Iterator[str]:
    for parameter in struct.parameters:
        if not stack or _is_small(parameter):
            yield f"{indent}{_type(parameter)} {parameter.name}{_default(parameter)};"
    for inner in struct.structs:
        if stack and inner.mapped:
            continue
        name = _pascal(inner.name)
        yield f"{indent}struct {name}\n{indent}{{"
        yield from _fields(inner, indent + "  ", stack)
        yield f"{indent}}}{'' if inner.mapped else ' ' + inner.name};"
        if inner.mapped:
            yield f"{indent}std::map<std::string, {name}> {_map(inner)};"


def _is_small(parameter: Parameter) -> bool:
    return bool(parameter.size) or not (parameter.kind == "string" or parameter.kind.endswith("_array"))


def _type(parameter: Parameter) -> str:
    if parameter.size:
        return (
            f"StaticString<{parameter.size}>"
            if parameter.kind == "string"
            else f"StaticVector<{parameter.base}, {parameter.size}>"
        )
    return str(TYPES[parameter.kind])


def _default(parameter: Parameter) -> str:
    return "{}" if parameter.default is None else f" = {value_text(parameter.default)}"


def _pascal(name: str) -> str:
    """
    >>> _pascal("__map_dof_names")
    'MapDofNames'
    """
    return "".join(word.title() for word in name.replace(".", "_").split("_"))


def _map(struct: Struct) -> str:
    return f"{struct.mapped.replace('.', '_')}_map"


def value_text(value: Any) -> str:
    """Return a value as C++ writes it.

    >>> value_text([1.0, float("nan")]), value_text('say "a"'), value_text(True)
    ('{1.0, std::numeric_limits<double>::quiet_NaN()}', '"say \\\\"a\\\\""', 'true')
    """
    if isinstance(value, list):
        return "{" + ", ".join(map(value_text, value)) + "}"
    if isinstance(value, float) and not math.isfinite(value):
        limit = "quiet_NaN" if math.isnan(value) else "infinity"
        return f"{'-' if value < 0 else ''}std::numeric_limits<double>::{limit}()"
    return json.dumps(value, ensure_ascii=False)


# -- what is said of each parameter


def _each(struct: Struct, place: str, name: str, mapped: bool, keys: int = 0) -> Iterator[str]:
    """Calls for the parameters below a struct, within loops over the `keys` parameters that name them."""
    for parameter in struct.parameters:
        if bool(keys) == mapped:
            yield _call(parameter, f"{place}.{parameter.name}", f"{name}{parameter.name}")
    for inner in struct.structs:
        if not inner.mapped:
            yield from _each(inner, f"{place}.{inner.name}", f"{name}{inner.name}.", mapped, keys)
        elif mapped:
            key = f"key_{keys}"
            yield f"    for (const std::string & {key} : params.{inner.mapped}) {{"
            yield from _each(inner, f"{place}.{_map(inner)}[{key}]", f"{name}{{{key}}}.", mapped, keys + 1)
            yield "    }"


def _call(parameter: Parameter, field: str, name: str) -> str:
    checks = "".join(_CHECK.format(call=_check(parameter, check, given)) for check, given in parameter.checks)
    words = value_text(name).replace("{", '" + ').replace("}", ' + "')
    has_default = value_text(parameter.default is not None)
    param = "param" if checks else ""
    return _EACH.format(
        name=words, field=field, has_default=has_default, descriptor=_descriptor(parameter), param=param, checks=checks
    )


def _check(parameter: Parameter, name: str, given: list[Any]) -> str:
    called = name.replace("<>", f"<{parameter.base}>")
    return f"{called}({', '.join(['param', *map(value_text, given)])})"


def _descriptor(parameter: Parameter) -> str:
    words = [parameter.description, parameter.read_only, parameter.additional_constraints]
    told = f"coursekit::described({', '.join(map(value_text, words))})"
    limits = {end: value_text(limit) for end, limit in parameter.limits.items()}
    if not limits:
        return told
    number, widest = ("double", "double") if parameter.kind == "double" else ("int64_t", "int")
    lower = limits.get(0, f"std::numeric_limits<{widest}>::lowest()")
    upper = limits.get(1, f"std::numeric_limits<{widest}>::max()")
    return f"coursekit::in_range({told}, {number}({lower}), {number}({upper}))"


def _forget(struct: Struct, place: str) -> Iterator[str]:
    """Statements that take what no name stands for any more out of the maps."""
    for inner in struct.structs:
        if inner.mapped:
            there = f"{place}.{_map(inner)}"
            yield f"    for (auto at = {there}.begin(); at != {there}.end();) {{"
            yield f"      at = contains(params.{inner.mapped}, at->first) ? std::next(at) : {there}.erase(at);"
            yield "    }"
        else:
            yield from _forget(inner, f"{place}.{inner.name}")


def _on_stack(struct: Struct, place: str) -> Iterator[str]:
    for parameter in struct.parameters:
        if _is_small(parameter):
            yield place + parameter.name
    for inner in struct.structs:
        if not inner.mapped:
            yield from _on_stack(inner, f"{place}{inner.name}.")
