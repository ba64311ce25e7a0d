"""Tables of teachers, saved by a learning platform or a spreadsheet in any common format."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from coursekit.files import write_whole

from .sanitizing import number

LARGEST = 32 << 20
"""The maximum size of a table [bytes]."""


@dataclass(frozen=True)
class Form:
    """The CSV format of a spreadsheet: most of Europe and South America use semicolons and decimal commas.

    >>> SEMICOLON.number(1.5)
    '1,5'
    """

    separator: str = ","
    decimal: str = "."

    def number(self, value: float) -> str:
        """Format points for a table of this format."""
        return number(value).replace(".", self.decimal)


COMMA, SEMICOLON = Form(), Form(";", ",")
FORMS = {"comma": COMMA, "semicolon": SEMICOLON}
_DECIMALS = re.compile(r"-?\d+([.,])\d+")


@dataclass
class Table:
    """Rows of texts under headings."""

    headings: list[str]
    rows: list[list[str]] = field(default_factory=list)
    separator: str = ","

    def dicts(self) -> list[dict[str, str]]:
        """Return the rows by heading; missing cells are ''.

        >>> Table(["student", "points"], [["Ada", "3"], ["Bob"]]).dicts()
        [{'student': 'Ada', 'points': '3'}, {'student': 'Bob', 'points': ''}]
        """
        return [dict(zip(self.headings, [*row, *[""] * len(self.headings)], strict=False)) for row in self.rows]

    @property
    def form(self) -> Form:
        """The format: the decimal sign of most numbers; without any, semicolons imply decimal commas.

        >>> Table(["mark"], [["7"]], ";").form.decimal, Table(["mark"], [["7.50"]], ";").form.decimal
        (',', '.')
        """
        signs = [match[1] for row in self.rows for cell in row if (match := _DECIMALS.fullmatch(cell))]
        commas, points = signs.count(","), signs.count(".")
        usual = "," if self.separator == ";" else "."
        return Form(self.separator, usual if commas == points else "," if commas > points else ".")


def decoded(data: bytes) -> str:
    r"""Decode a file with lines ending in `\n`: UTF-16 or UTF-8 by byte order mark, else UTF-8, else Windows' encoding.

    >>> decoded("José".encode("utf-16")), decoded("José".encode("utf-8-sig")), decoded(b"Jos\xe9\r")
    ('José', 'José', 'José\n')
    """
    return _text(data).replace("\r\n", "\n").replace("\r", "\n")


def _text(data: bytes) -> str:
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return data.decode("utf-16", "replace").lstrip("\ufeff")
    if data[1:2] == b"\0" and data[:1] != b"\0":
        return data.decode("utf-16-le", "replace")
    try:
        return data.decode("utf-8-sig").lstrip("\ufeff")
    except UnicodeDecodeError:
        return data.decode("cp1252", "replace")


def separator_of(text: str) -> str:
    """Return comma, semicolon or tab: the most regular one in the first lines, outside of quotation marks.

    >>> separator_of("Name;E-mail\\nLee, Ann;ann@uni")
    ';'
    """
    if text[:4].casefold() == "sep=":
        return text[4:5]
    best, most = ",", 0
    for separator in (";", "\t", ","):
        widths = [len(row) for row in csv.reader(io.StringIO(text[:20_000]), delimiter=separator)][:20]
        width = min((width for width in widths if width), default=0)
        if width > max(1, most):
            best, most = separator, width
    return best


def read_table(file: Path) -> Table:
    """Read the table in a file.

    Raises:
        ValueError: when it is too large, empty, or not a text.
        OSError: when it cannot be read.
    """
    if file.stat().st_size > LARGEST:
        raise ValueError(f"{file} is larger than {LARGEST >> 20} MB: that is no table.")
    text = decoded(file.read_bytes())
    if "\0" in text or text[:2] == "PK":
        raise ValueError(f"{file} is no table of text. Save it as CSV.")
    lines = text.split("\n", 1)[1] if text[:4].casefold() == "sep=" else text
    try:
        separator = separator_of(text)
        rows = [[cell.strip() for cell in row] for row in csv.reader(io.StringIO(lines), delimiter=separator) if any(row)]
    except csv.Error as error:
        raise ValueError(f"{file} is no table: {error}.") from None
    if not rows:
        raise ValueError(f"There is nothing in {file}.")
    return Table(rows[0], rows[1:], separator)


def write_table(
    file: Path, headings: Sequence[str], rows: Iterable[Sequence[str] | Mapping[str, str]], form: Form = COMMA
) -> None:
    """Write a table atomically. The caller has made the cells harmless, and has formatted the numbers.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     write_table(Path(folder, "marks.csv"), ["student", "points"], [["Ada", "1,5"]], SEMICOLON)
    ...     table = read_table(Path(folder, "marks.csv"))
    >>> table.separator, table.rows
    (';', [['Ada', '1,5']])
    """
    buffer = io.StringIO()
    table = csv.writer(buffer, delimiter=form.separator)
    table.writerow(headings)
    for row in rows:
        table.writerow([row.get(heading, "") for heading in headings] if isinstance(row, Mapping) else row)
    text = buffer.getvalue()
    write_whole(file, text.encode("utf-8" if text.isascii() else "utf-8-sig", "replace"), parents=True)
