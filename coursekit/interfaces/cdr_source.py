"""Python source of the functions that convert one message type to CDR bytes and back."""

from __future__ import annotations

from collections.abc import Callable

from coursekit.interfaces.cdr_runs import FORMATS, SIZES, Item
from coursekit.interfaces.fields import DTYPES, TYPE_CODES
from coursekit.interfaces.model import FieldType, Message

Find = Callable[[str], Message]


class _Source:
    """Lines of one function; neighbouring values of fixed size wait in `pending` for one struct call."""

    def __init__(self, find: Find) -> None:
        self.find = find
        self.lines: list[str] = []
        self.runs: list[str] = []
        self.pending: list[Item] = []
        self.names = 0

    def fresh(self, stem: str) -> str:
        self.names += 1
        return f"{stem}{self.names}"

    def table(self) -> str:
        items = ", ".join(f"({item.align}, {item.code!r})" for item in self.pending)
        self.runs.append(f"run({items})")
        return f"RUN{len(self.runs) - 1}"

    def add(self, base: str, name: str) -> None:
        self.pending.append(Item(SIZES[base], FORMATS[base], name))

    def message(self, message: Message, name: str) -> None:
        if not message.fields:
            self.add("uint8", self.dummy())
        for field in message.fields:
            self.value(field.type, f"{name}._{field.name}")

    def value(self, kind: FieldType, name: str) -> None:
        if not kind.is_array:
            self.scalar(kind, name)
        elif kind.is_fixed:
            self.fixed(kind, name)
        else:
            self.sequence(kind, name)

    def scalar(self, kind: FieldType, name: str) -> None:
        if not kind.is_primitive:
            self.nested(kind.base, name)
        elif kind.base in FORMATS:
            self.add(kind.base, name)
        else:
            self.string(kind, name)

    def dummy(self) -> str:
        raise NotImplementedError

    def nested(self, base: str, name: str) -> None:
        raise NotImplementedError

    def string(self, kind: FieldType, name: str) -> None:
        raise NotImplementedError

    def fixed(self, kind: FieldType, name: str) -> None:
        raise NotImplementedError

    def sequence(self, kind: FieldType, name: str) -> None:
        raise NotImplementedError


class _Writer(_Source):
    def flush(self) -> None:
        if self.pending:
            values = ", ".join(item.name for item in self.pending)
            self.lines.append(f"out += {self.table()}[(len(out) + 4) & 7].pack({values})")
            self.pending = []

    def dummy(self) -> str:
        return "0"

    def nested(self, base: str, name: str) -> None:
        self.message(self.find(base), name)

    def string(self, kind: FieldType, name: str) -> None:
        data = self.fresh("text")
        wide = kind.base == "wstring"
        self.lines.append(f"{data} = encode_wide({name})" if wide else f"{data} = {name}.encode() + b'\\0'")
        self.add("uint32", f"len({data}) // 4" if wide else f"len({data})")
        self.flush()
        self.lines.append(f"out += {data}")

    def fixed(self, kind: FieldType, name: str) -> None:
        if kind.is_number_block:
            self.pending.append(_bytes_item(kind, f"{name}.tobytes()"))
            return
        self.lines.append(f"exactly({name}, {kind.size}, {name.rpartition('._')[2]!r})")
        if kind.base in ("bool", "byte"):
            self.pending.append(_bytes_item(kind, _joined(kind, name)))
            return
        self.flush()
        self.elements(kind, name)

    def sequence(self, kind: FieldType, name: str) -> None:
        if kind.size:
            self.lines.append(f"at_most({name}, {kind.size}, {name.rpartition('._')[2]!r})")
        self.add("uint32", f"len({name})")
        self.flush()
        if kind.is_number_block:
            if SIZES[kind.base] == 8:
                self.lines.append(f"if {name}: out += PAD[(len(out) + 4) & 7]")
            self.lines.append(f"out += {name}")
        elif kind.base in ("bool", "byte"):
            self.lines.append(f"out += {_joined(kind, name)}")
        else:
            self.elements(kind, name)

    def elements(self, kind: FieldType, name: str) -> None:
        call = {"string": "write_string(out, item)", "wstring": "write_wide(out, item)"}.get(kind.base)
        self.lines.append(f"for item in {name}: {call or f'codec({kind.base!r}).write(item, out)'}")


def _bytes_item(kind: FieldType, name: str) -> Item:
    assert kind.size is not None
    return Item(SIZES[kind.base], f"{kind.size * SIZES[kind.base]}s", name)


def _joined(kind: FieldType, name: str) -> str:
    return f"bytes({name})" if kind.base == "bool" else f"b''.join({name})"


class _Reader(_Source):
    def __init__(self, find: Find) -> None:
        super().__init__(find)
        self.after: list[str] = []

    def flush(self) -> None:
        if self.pending:
            names = ", ".join(item.name for item in self.pending)
            self.lines.append(f"layout = {self.table()}[pos & 7]")
            self.lines.append(f"{names}, = layout.unpack_from(body, pos)")
            self.lines.append("pos += layout.size")
            self.pending = []
        self.lines += self.after
        self.after = []

    def dummy(self) -> str:
        return "_"

    def nested(self, base: str, name: str) -> None:
        part = self.fresh("part")
        self.lines += [f"{part} = new(cls({base!r}))", f"{name} = {part}"]
        self.message(self.find(base), part)

    def string(self, kind: FieldType, name: str) -> None:
        count = self.fresh("count")
        self.add("uint32", count)
        self.flush()
        if kind.base == "wstring":
            self.lines += [
                f"{name} = decode_wide(bytes(take(body, pos, 4 * {count})))",
                f"pos += 4 * {count}",
            ]
            return
        if kind.string_bound:
            self.lines.append(
                f"at_most(range({count} - 1), {4 * kind.string_bound}, {name.rpartition('._')[2]!r})"
            )
        self.lines.append(f"{name} = str(take(body, pos, {count})[:-1], 'utf-8', 'replace')")
        self.lines.append(f"pos += {count}")

    def fixed(self, kind: FieldType, name: str) -> None:
        if kind.base in FORMATS:
            data = self.fresh("data")
            self.pending.append(_bytes_item(kind, data))
            self.after.append(f"{name} = {self.from_bytes(kind, data)}")
            return
        self.flush()
        self.elements(kind, name, str(kind.size))

    @staticmethod
    def from_bytes(kind: FieldType, data: str) -> str:
        if kind.base == "bool":
            return f"[value != 0 for value in {data}]"
        if kind.base == "byte":
            return f"[bytes((value,)) for value in {data}]"
        order = "<" if SIZES[kind.base] > 1 else "|"
        return (
            f"numpy.frombuffer({data}, dtype=numpy.dtype(numpy.{DTYPES[kind.base]}).newbyteorder({order!r}))"
            + (f".astype(numpy.{DTYPES[kind.base]})")
        )

    def sequence(self, kind: FieldType, name: str) -> None:
        count = self.fresh("count")
        self.add("uint32", count)
        self.flush()
        if kind.size:
            self.lines.append(f"at_most(range({count}), {kind.size}, {name.rpartition('._')[2]!r})")
        if kind.is_number_block:
            self.lines.append(f"{name}, pos = read_block(body, pos, {TYPE_CODES[kind.base]!r}, {count})")
        elif kind.base in ("bool", "byte"):
            self.lines.append(f"{name} = {self.from_bytes(kind, f'take(body, pos, {count})')}")
            self.lines.append(f"pos += {count}")
        else:
            self.elements(kind, name, count)

    def elements(self, kind: FieldType, name: str, count: str) -> None:
        items = self.fresh("items")
        bound = f", {kind.string_bound}" if kind.string_bound and kind.base == "string" else ""
        call = {"string": f"read_string(body, pos{bound})", "wstring": "read_wide(body, pos)"}.get(kind.base)
        call = call or f"codec({kind.base!r}).read(body, pos)"
        self.lines += [f"{name} = {items} = []", f"for _ in range({count}):", f"    item, pos = {call}"]
        self.lines.append(f"    {items}.append(item)")


def codec_source(message: Message, find: Find) -> str:
    """Return the source of `write(message, out)` and `read(body, pos)` for one message type.

    The names it uses are supplied by coursekit.interfaces.cdr: RUNs, codec, cls, new and the helpers of cdr_runs.
    """
    writer, reader = _Writer(find), _Reader(find)
    writer.message(message, "msg")
    writer.flush()
    reader.runs = writer.runs
    reader.message(message, "msg")
    reader.flush()
    tables = [f"RUN{index} = {text}" for index, text in enumerate(writer.runs)]
    write = ["def write(msg, out):", *(f"    {line}" for line in writer.lines)]
    read = ["def read(body, pos):", f"    msg = new(cls({message.full_name!r}))"]
    read += [*(f"    {line}" for line in reader.lines), "    return msg, pos"]
    return "\n".join([*tables, "", "", *write, "", "", *read, ""])
