"""Translates OMG IDL, as far as ROS uses it, to the text of a .msg, .srv or .action file, the input of all other code."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

from lark import Lark, Token, Tree
from lark.exceptions import UnexpectedInput

from coursekit.files import read_text
from coursekit.interfaces.errors import InterfaceError
from coursekit.interfaces.model import Interface
from coursekit.interfaces.parser import parse

_GRAMMAR = r"""
start: module+
module: _note* "module" NAME "{" (module | struct | typedef | const)* "}" ";"
typedef: _note* "typedef" type declared ";"
const: _note* "const" type NAME "=" value ";"
struct: _note* "struct" NAME "{" member* "}" ";"
member: (default | other)* type declared ("," declared)* ";"
declared: NAME ("[" INT "]")?
_note: other
default.2: "@default" "(" "value" "=" value ")"
other: "@" NAME ["(" (NAME "=")? value ("," NAME "=" value)* ")"]
type: "sequence" "<" type ["," INT] ">" -> sequence
    | TEXT_KIND ["<" INT ">"] -> text
    | BASIC -> basic
    | NAME ("::" NAME)* -> named
value: STRING+ | NUMBER | NAME
TEXT_KIND.3: /w?string\b/
BASIC.3: /((unsigned\s+)?(long\s+long|long|short)|float|double|boolean|octet|char|u?int(8|16|32|64))\b/
NAME: /[A-Za-z_]\w*/
INT: /\d+/
NUMBER.2: /[-+]?(0x[0-9a-fA-F]+|\d+\.?\d*([eE][-+]?\d+)?|\.\d+)/
STRING: /"(\\.|[^"\\])*"/s
%ignore /\s+|\/\/[^\n]*|\/\*.*?\*\/|#[^\n]*/s
"""
_BASIC = {
    "boolean": "bool", "octet": "byte", "float": "float32", "double": "float64", "short": "int16", "long": "int32",
    "long long": "int64", "unsigned short": "uint16", "unsigned long": "uint32", "unsigned long long": "uint64",
}  # fmt: skip
_PARTS = {"msg": ("",), "srv": ("_Request", "_Response"), "action": ("_Goal", "_Result", "_Feedback")}
_FILLER = "structure_needs_at_least_one_member"
"""The member of structures that are empty in ROS: IDL requires one."""


def definition_of_idl(path: Path) -> tuple[str, str]:
    """Return the kind of the interface in an .idl file, and its definition as a .msg, .srv or .action text.

    Raises InterfaceError, with file and line, for text that ROS would not accept.
    """
    return _Definition(path, _tree(read_text(path), str(path))).text()


def interface_of_idl(text: str) -> Interface:
    """Return the interface that a text in IDL defines: its first structure tells the name.

    Raises InterfaceError for text that ROS would not accept.
    """
    told = _Definition(Path("text.idl"), _tree(text, "text.idl"))
    first = next(iter(told.structs), "")
    name = first.removesuffix("_Request").removesuffix("_Goal")
    told.path = Path(f"{name}.idl")
    kind, definition = told.text()
    return parse(told.kinds[0], kind, name, definition)


def _tree(text: str, file: str) -> Tree[Any]:
    try:
        return _parser().parse(text)
    except UnexpectedInput as error:
        source = text.splitlines()[error.line - 1 : error.line] if error.line > 0 else []
        why = "this is not IDL as ROS knows it"
        raise InterfaceError(why, file=file, line=max(error.line, 1), source="".join(source)) from None


@cache
def _parser() -> Lark:
    """Return the grammar's parser, whose tables take longer to make than a file to read."""
    return Lark(_GRAMMAR, parser="lalr")


class _Definition:
    def __init__(self, path: Path, tree: Tree[Any]) -> None:
        self.path = path
        self.kinds = [str(module.children[0]) for module in tree.iter_subtrees_topdown() if module.data == "module"]
        self.types = {str(typedef.children[-1].children[0]): typedef for typedef in tree.find_data("typedef")}
        self.structs = {str(_name(struct)): struct for struct in tree.find_data("struct")}
        self.constants = {str(module.children[0]): module for module in tree.find_data("module")}

    def text(self) -> tuple[str, str]:
        kind = next((part for part in self.kinds if part in _PARTS), "")
        if not kind:
            raise self._error("its structures are to be in a module msg, srv or action")
        return kind, "---\n".join(self._part(self.path.stem + end) for end in _PARTS[kind])

    def _part(self, name: str) -> str:
        if name not in self.structs:
            raise self._error(f"there is no struct {name} in it, as its name says")
        lines = []
        if f"{name}_Constants" in self.constants:
            for const in self.constants[f"{name}_Constants"].find_data("const"):
                kind, label, value = const.children[-3:]
                lines.append(f"{self._type(kind)} {label}={_value(value)}")
        for member in self.structs[name].find_data("member"):
            lines += self._fields(member)
        return "".join(f"{line}\n" for line in lines)

    def _fields(self, member: Tree[Any]) -> list[str]:
        default = next((f" {_value(child.children[0])}" for child in member.find_data("default")), "")
        kind = next(child for child in member.children if child.data not in ("default", "other", "declared"))
        declared = [child.children for child in member.children if child.data == "declared"]
        named = [(str(name), str(size[0]) if size else "") for name, *size in declared if name != _FILLER]
        return [f"{self._type(kind, size)} {name}{default}" for name, size in named]

    def _type(self, kind: Tree[Any], size: str = "") -> str:
        ends = f"[{size}]" if size else ""
        if kind.data == "sequence":
            inner, bound = kind.children
            element = self._type(inner)
            if ends or element.endswith("]"):
                raise self._error("ROS has no arrays of arrays")
            return f"{element}[{f'<={bound}' if bound else ''}]"
        if kind.data == "text":
            base, bound = kind.children
            return f"{base}{f'<={bound}' if bound else ''}{ends}"
        if kind.data == "basic":
            words = " ".join(str(kind.children[0]).split())
            return _BASIC.get(words, words) + ends
        names = [str(child) for child in kind.children]
        alias = self.types.get(names[-1]) if len(names) == 1 else None
        if alias is None:
            return "/".join(name for name in names if name != "msg") + ends
        inner, declared = alias.children[-2:]
        return self._type(inner, str(declared.children[1]) if len(declared.children) > 1 else size)

    def _error(self, why: str) -> InterfaceError:
        return InterfaceError(why, file=str(self.path))


def _name(struct: Tree[Any]) -> Token:
    return next(child for child in struct.children if isinstance(child, Token))


def _value(value: Tree[Any]) -> str:
    """Return a constant or a default in .msg syntax; IDL writes lists as strings in parentheses."""
    parts = [str(child) for child in value.children]
    if not parts[0].startswith('"'):
        return {"TRUE": "true", "FALSE": "false"}.get(parts[0], parts[0])
    text = "".join(part[1:-1] for part in parts)
    return f"[{text[1:-1]}]" if text.startswith("(") and text.endswith(")") else f'"{text}"'
