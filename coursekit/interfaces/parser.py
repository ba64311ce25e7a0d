"""The reader of .msg, .srv and .action text.

In ROS 2: rosidl_adapter. The grammar is Humble's; the errors name file, line and column.
"""

from __future__ import annotations

import keyword
import re
from collections.abc import Sequence
from pathlib import Path

from coursekit.files import read_text
from coursekit.interfaces.errors import InterfaceError, suggestion
from coursekit.interfaces.literals import LiteralError, parse_scalar, parse_value
from coursekit.interfaces.model import (
    PRIMITIVES,
    Action,
    Constant,
    Field,
    FieldType,
    Interface,
    Message,
    Service,
)

PACKAGE_NAME = re.compile(r"(?!.*__)(?!.*_$)[a-z][a-z0-9_]*")
MESSAGE_NAME = re.compile(r"[A-Z][A-Za-z0-9]*")
CONSTANT_NAME = re.compile(r"(?!.*__)(?!.*_$)[A-Z][A-Z0-9_]*")
_TYPE = re.compile(
    r"(?P<base>[^\[\]<]+)(?:<=(?P<bound>[^\[\]]*))?(?P<array>\[(?P<upper><=)?(?P<size>[^\]]*)\])?"
)
_ARRAY_NAME = re.compile(r"(?P<name>\w+)(?P<brackets>\[[^\]]*\])")
_OTHER_LANGUAGES = {"int": "int32", "long": "int64", "float": "float32", "double": "float64", "str": "string"}
"""What C++ and Python call types that have other names here."""
_INTEGER = re.compile(r"[0-9]+")
_LONGEST = 2**31 - 1


class _Reader:
    """Reads the lines of one structure; adds their locations to errors."""

    def __init__(
        self, package: str, kind: str, name: str, lines: Sequence[str], file: str, first: int
    ) -> None:
        self.package, self.kind, self.name, self.lines, self.file, self.first = (
            package,
            kind,
            name,
            lines,
            file,
            first,
        )
        self.fields: list[Field] = []
        self.constants: list[Constant] = []
        self.comments: list[str] = []

    def error(self, message: str, index: int, column: int = 1) -> InterfaceError:
        line, source = self.first + index + 1, self.lines[index].replace("\t", " ")
        return InterfaceError(message, file=self.file, line=line, column=column, source=source)

    def read(self) -> Message:
        head = self._file_comment()
        for index in range(len(head), len(self.lines)):
            self._line(index)
        return Message(
            self.package,
            self.kind,
            self.name,
            tuple(self.fields),
            tuple(self.constants),
            "\n".join(head),
            self.file,
            tuple(self.lines),
        )

    def _file_comment(self) -> list[str]:
        head = []
        for line in self.lines:
            if not line.startswith("#"):
                break
            head.append(line.lstrip("#").strip())
        return head

    def _line(self, index: int) -> None:
        text, sharp, comment = self.lines[index].replace("\t", " ").partition("#")
        if sharp:
            self.comments.append(comment.lstrip("#").strip())
        if not text.strip():
            return
        self._statement(text.rstrip(), index, bool(sharp))
        self.comments = []

    def _statement(self, text: str, index: int, commented: bool) -> None:
        if text[0] == " ":
            raise self.error("a definition starts in the first column of its line", index)
        type_text, _, rest = text.partition(" ")
        rest_column = len(text) - len(rest.lstrip()) + 1
        rest = rest.strip()
        kind = self._type(type_text, index)
        if not rest:
            raise self.error(f"'{type_text}' needs a name after it, as in '{type_text} my_field'", index)
        if "=" in rest:
            self._constant(kind, rest, index, rest_column, commented)
        else:
            self._field(kind, rest, index, rest_column, commented)

    def _constant(self, kind: FieldType, rest: str, index: int, name_column: int, commented: bool) -> None:
        name, _, value_text = rest.partition("=")
        name, value_text = name.rstrip(), value_text.strip()
        if not CONSTANT_NAME.fullmatch(name):
            why = f"'{name}' is no constant name: use capitals, digits and single underscores, as in MY_VALUE"
            if PACKAGE_NAME.fullmatch(name):
                why += "; a default value stands behind the name without '='"
            raise self.error(why, index, name_column)
        if kind.base not in PRIMITIVES or kind.is_array or kind.string_bound:
            raise self.error(f"the constant type '{kind}' must be a primitive type", index)
        self._unique(name, [c.name for c in self.constants], index, name_column)
        value_column = name_column + rest.index("=") + 1
        self._quotes(value_text, index, value_column, commented)
        try:
            value = parse_scalar(kind, value_text)
        except LiteralError as error:
            raise self.error(str(error), index, value_column) from None
        self.constants.append(Constant(kind, name, value, " ".join(self.comments)))

    def _field(self, kind: FieldType, rest: str, index: int, name_column: int, commented: bool) -> None:
        name, _, value_text = rest.partition(" ")
        value_text = value_text.strip()
        self._field_name(name, kind, index, name_column)
        default = None
        if value_text:
            value_column = name_column + len(rest) - len(value_text)
            self._quotes(value_text, index, value_column, commented)
            try:
                default = parse_value(kind, value_text)
            except LiteralError as error:
                raise self.error(str(error), index, value_column) from None
        self.fields.append(Field(kind, name, default, " ".join(self.comments), self.first + index + 1))

    def _field_name(self, name: str, kind: FieldType, index: int, column: int) -> None:
        if (array := _ARRAY_NAME.fullmatch(name)) and not kind.is_array:
            why = f"the brackets stand behind the type: {kind}{array['brackets']} {array['name']}"
            raise self.error(why, index, column)
        if not PACKAGE_NAME.fullmatch(name):
            why = (
                f"'{name}' is no field name: use small letters, digits and single underscores, as in my_field"
            )
            raise self.error(why, index, column)
        if keyword.iskeyword(name):
            raise self.error(
                f"'{name}' is a word of Python's grammar; choose another field name", index, column
            )
        self._unique(name, [f.name for f in self.fields], index, column)

    def _unique(self, name: str, known: list[str], index: int, column: int) -> None:
        if name in known:
            raise self.error(f"'{name}' is already defined above", index, column)

    def _quotes(self, value: str, index: int, column: int, commented: bool) -> None:
        if commented and value[:1] in ('"', "'") and (len(value) == 1 or value[-1] != value[0]):
            raise self.error("the string has no end: '#' starts a comment even between quotes", index, column)

    def _type(self, text: str, index: int) -> FieldType:
        match = _TYPE.fullmatch(text)
        if match is None:
            raise self.error(f"'{text}' is no type; write e.g. float64, string<=10, int32[], int32[3]", index)
        base = self._base(match["base"], index)
        bound = None
        if match["bound"] is not None:
            if base not in ("string", "wstring"):
                raise self.error(f"only string and wstring can have a bound, not '{base}'", index)
            bound = self._count(match["bound"], "the upper bound of a string", index)
        if not match["array"]:
            return FieldType(base, bound)
        size = None
        if match["size"] or match["upper"]:
            size = self._count(match["size"], "the size of an array", index)
        return FieldType(base, bound, True, size, bool(match["upper"]))

    def _count(self, text: str, what: str, index: int) -> int:
        if not _INTEGER.fullmatch(text) or not 0 < int(text[:12]) <= _LONGEST:
            raise self.error(f"{what} must be a valid integer value > 0, not '{text}'", index)
        return int(text)

    def _base(self, base: str, index: int) -> str:
        if base in PRIMITIVES:
            return base
        parts = base.split("/")
        if len(parts) == 3 and parts[1] == "msg":  # the form used elsewhere; rosidl's parser refuses it too
            raise self.error(f"in a definition '{base}' is written {parts[0]}/{parts[2]}", index)
        package, name = parts if len(parts) == 2 else (self.package, base)
        if base in ("time", "duration"):
            known = f"builtin_interfaces/{base.capitalize()}"
            raise self.error(f"ROS 2 has no type '{base}'; write {known}", index)
        if not MESSAGE_NAME.fullmatch(name) or not PACKAGE_NAME.fullmatch(package):
            raise self.error(f"unknown type '{base}'{self._meant(base, index)}", index)
        return f"{package}/msg/{name}"

    def _meant(self, base: str, index: int) -> str:
        """The end of a message about an unknown type: what may have been meant."""
        words = self.lines[index].split()
        if len(words) > 1 and (words[1] in PRIMITIVES or "/" in words[1]) and words[0] == base:
            return f"; the type stands first, then the name: {words[1]} {base}"
        if other := _OTHER_LANGUAGES.get(base):
            return f"; did you mean '{other}'?"
        return suggestion(base, PRIMITIVES) or f"; known: {', '.join(PRIMITIVES)} or package/Name"


def parse(package: str, kind: str, name: str, text: str, file: str = "") -> Interface:
    """Parse the text of a definition; `kind` is 'msg', 'srv' or 'action'.

    Raises InterfaceError with file, line and column.

    >>> parse('p', 'msg', 'A', 'float64 x 1.5').fields[0].default
    1.5
    """
    lines = text.lstrip("\ufeff").splitlines()
    if not MESSAGE_NAME.fullmatch(name):
        why = f"'{name}' is no interface name: start with a capital and use letters and digits, as in MyType"
        raise InterfaceError(why, file=file)
    if kind == "msg":
        return _Reader(package, kind, name, lines, file, 0).read()
    suffixes = ("_Request", "_Response") if kind == "srv" else ("_Goal", "_Result", "_Feedback")
    messages = []
    for suffix, (first, part) in zip(suffixes, _parts(lines, len(suffixes), kind, file), strict=True):
        messages.append(_Reader(package, kind, name + suffix, part, file, first).read())
    return Service(package, name, *messages) if kind == "srv" else Action(package, name, *messages)


def _parts(lines: list[str], count: int, kind: str, file: str) -> list[tuple[int, list[str]]]:
    cuts = [index for index, line in enumerate(lines) if line == "---"]
    if len(cuts) != count - 1:
        index = cuts[count - 1] if len(cuts) >= count else max(len(lines) - 1, 0)
        source = lines[index] if lines else ""
        why = f"a .{kind} file has {count - 1} line(s) '---' between its parts; this one has {len(cuts)}"
        raise InterfaceError(why, file=file, line=index + 1, source=source)
    starts, ends = [0, *(cut + 1 for cut in cuts)], [*cuts, len(lines)]
    return [(start, lines[start:end]) for start, end in zip(starts, ends, strict=True)]


def parse_file(package: str, path: Path) -> Interface:
    """Read one definition file; its suffix is the kind, its stem the name."""
    try:
        text = read_text(path)
    except OSError as error:
        raise InterfaceError(f"the file cannot be read: {error.strerror}", file=str(path)) from None
    except UnicodeDecodeError as error:
        raise InterfaceError(
            f"the file is not UTF-8 text ({error.reason} at byte {error.start})", file=str(path)
        ) from None
    kind = path.suffix[1:]
    if kind not in ("msg", "srv", "action"):
        raise InterfaceError("interface files end in .msg, .srv or .action", file=str(path))
    return parse(package, kind, path.stem, text, str(path))
