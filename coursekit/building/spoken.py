"""The texts of panels and checks for translation, extracted from the sources."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import polib

from coursekit.files import read_text
from coursekit.grade.statuses import STATUSES
from coursekit.lab.script import said_in
from coursekit.words.gettext import FIELD, catalogue_of

PACKAGE = Path(__file__).parents[1]
_JUDGES = (
    "answer_age", "cell_before", "checking", "command_advice", "exception_advice",
    "outputs", "plain", "reader", "reading", "stopped_function", "trial", "verdict", "work",
)  # fmt: skip
_MARKING = (
    "examiner", "handing_in", "repair", "chapter_files", "collector", "mark", "recognising", "archives", "submission_parts",
)  # fmt: skip
_CODE = re.compile(
    r"(run|launch|ros2|from|import|colcon|action|padding|var\(|<|#|--|-r|%|\^)|.*(\\|\(\^|\.\*|\(\[|\(\?|surrogatepass)"
)
"""Texts that are not sentences: command lines, styles, patterns."""
_PLAIN = ("BadArgument", "NotNow", "NotThere")
"""Exceptions that a notebook displays as two lines in the course's language."""


def spoken() -> dict[str, str]:
    """Return every text with the first file that contains it; the fields filled in at run time are `{0}`, `{1}`, ..."""
    file_by_text: dict[str, str] = {}
    for file, texts in _all():
        for text in texts:
            file_by_text.setdefault(text, file.relative_to(PACKAGE).as_posix())
    return file_by_text


def _all() -> Iterator[tuple[Path, Iterator[str]]]:
    grade, view = PACKAGE / "grade", PACKAGE / "view"
    judges = [*(grade / f"{name}.py" for name in (*_JUDGES, *_MARKING)), view / "graph_faults.py", view / "frame_facts.py"]
    judges += [*sorted(grade.glob("figures/*.py")), view / "scene_stage.py", view / "displays" / "silence.py"]
    judges += [PACKAGE / "suggestions.py"]
    for file in [*sorted(grade.glob("chapters/**/*.py")), *judges]:
        yield file, _of_judge(ast.parse(read_text(file)))  # parts of sentences that are translated when displayed
    yield grade / "statuses.py", iter(STATUSES)
    for file in sorted((PACKAGE / "lab").glob("*.py")):
        yield file, _of_errors(ast.parse(read_text(file)))
    displays = PACKAGE / "nodes" / "rviz" / "properties.py"
    yield displays, _of_judge(_constants(ast.parse(read_text(displays)))["ABOUT"])
    for file in sorted((PACKAGE / "lab" / "static").glob("*.js")):
        yield file, said_in(read_text(file))
    for file in sorted(path for room in ("grade", "lab", "view") for path in (PACKAGE / room).rglob("*.py")):
        yield file, _of_calls(ast.parse(read_text(file)))


def _of_calls(tree: ast.Module) -> Iterator[str]:
    """Yield the texts passed to gettext()."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "gettext":
            yield from filter(_words, (template(arg) for arg in node.args if isinstance(arg, (ast.Constant, ast.JoinedStr))))


def _of_errors(tree: ast.Module) -> Iterator[str]:
    """Yield the texts of the lab's exceptions, including constants of the same file."""
    constants = _constants(tree)
    for node in ast.walk(tree):
        if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call) and ast.unparse(node.exc.func) in _PLAIN:
            yield from _of_judge(node.exc)
            for part in ast.walk(node.exc):
                if isinstance(part, ast.Name) and isinstance(words := constants.get(part.id), ast.Constant):
                    yield from _of_judge(words)


def _constants(tree: ast.Module) -> dict[str, ast.expr]:
    return {
        ast.unparse(statement.targets[0]): statement.value for statement in tree.body if isinstance(statement, ast.Assign)
    }


def _of_judge(tree: ast.AST) -> Iterator[str]:
    """Yield the sentences in a judge's source: its texts with a space, and the words inserted into some of them."""
    silent = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}  # docstrings
    texts = [node for node in ast.walk(tree) if isinstance(node, (ast.Constant, ast.JoinedStr))]
    for node in sorted(texts, key=lambda node: (node.lineno, node.col_offset, isinstance(node, ast.Constant))):
        if isinstance(node, ast.JoinedStr):
            silent |= {id(inner) for inner in ast.walk(node) if inner is not node}
            yield from _alternatives(node)
        text = template(node)
        if id(node) not in silent and " " in text.strip() and _words(text) and not _CODE.match(text):
            yield text


def _words(text: str) -> bool:
    return any(map(str.isalpha, FIELD.sub("", text)))


def _alternatives(node: ast.JoinedStr) -> Iterator[str]:
    """Yield the alternative words in a sentence: `{'taken' if good else 'refused'}`, `{names or 'none'}`."""
    for inner in ast.walk(node):
        choices = [inner.body, inner.orelse] if isinstance(inner, ast.IfExp) else []
        choices += inner.values if isinstance(inner, ast.BoolOp) else []
        for choice in choices:
            text = template(choice) if isinstance(choice, ast.Constant) else ""
            if len(text) > 2 and text.replace(" ", "").isalpha():
                yield text


def template(node: ast.Constant | ast.JoinedStr) -> str:
    """Return a constant's text, or an f-string's with its fields numbered; '' for anything else.

    >>> template(ast.parse("f'{name} at {place!r} m'", mode="eval").body)
    '{0} at {1} m'
    """
    if isinstance(node, ast.Constant):
        return node.value if isinstance(node.value, str) else ""
    numbers = iter(range(len(node.values)))
    parts = (str(value.value) if isinstance(value, ast.Constant) else f"{{{next(numbers)}}}" for value in node.values)
    return "".join(parts)


def update_words(language: str) -> str:
    """Update the catalogue of a language's texts: add new ones without a translation, drop unused ones."""
    file = catalogue_of(language)
    old = {entry.msgid: entry.msgstr for entry in polib.pofile(str(file))} if file.is_file() else {}
    catalogue = polib.POFile(wrapwidth=0)
    catalogue.metadata = {"Content-Type": "text/plain; charset=utf-8", "Content-Transfer-Encoding": "8bit"}
    for text, where in spoken().items():
        catalogue.append(polib.POEntry(msgid=text, msgstr=old.get(text, ""), comment=where))
    file.write_text(str(catalogue).removeprefix("#\n"), encoding="utf-8")
    return f"{file.name}: {len(catalogue) - len(catalogue.translated_entries())} of {len(catalogue)} texts to translate"
