"""The words of checks and panels in Spanish: none is missing, none is left over, none loses a field."""

import re

import polib
import pytest

from coursekit.building.spoken import spoken
from coursekit.grade.verdict import Verdict
from coursekit.words.gettext import FIELD, LANGUAGE, catalogue_of, gettext, words_of

SPANISH = polib.pofile(str(catalogue_of("es")))


@pytest.fixture
def in_spanish(monkeypatch):
    monkeypatch.setenv(LANGUAGE, "es")


def test_every_word_has_its_spanish_and_no_other_is_there():
    assert sorted(entry.msgid for entry in SPANISH) == sorted(spoken())
    assert [entry.msgid for entry in SPANISH if not entry.msgstr.strip()] == []


@pytest.mark.parametrize("entry", SPANISH, ids=lambda one: one.msgid[:40])
def test_fields_and_code_are_those_of_the_english(entry):
    assert sorted(set(FIELD.findall(entry.msgid))) == sorted(set(FIELD.findall(entry.msgstr)))
    assert sorted(re.findall(r"`[^`]*`", entry.msgid)) == sorted(re.findall(r"`[^`]*`", entry.msgstr))
    assert [side.isspace() for side in (entry.msgid[0], entry.msgid[-1])] == [
        side.isspace() for side in (entry.msgstr[0], entry.msgstr[-1])
    ]


def test_english_stays_as_it_is(monkeypatch):
    monkeypatch.delenv(LANGUAGE, raising=False)
    assert gettext("at least 8 m of line") == "at least 8 m of line"
    monkeypatch.setenv(LANGUAGE, "../../etc")
    assert gettext("at least 8 m of line") == "at least 8 m of line"


def test_a_sentence_with_fields_is_found(in_spanish):
    assert gettext("warehouse 7") == "almacén 7"
    assert gettext("nodes: none; the program said: boom") == "nodos: ninguno; el programa dijo: boom"
    assert gettext("nobody translated this") == "nobody translated this"


def test_what_a_program_said_stays_as_it_said_it(in_spanish):
    assert gettext("none; it said: hello from a list") == "ninguno; dijo: hello from a list"
    long = "always " + "x" * 600
    assert gettext(long) == long


def test_a_verdict_in_spanish(in_spanish):
    verdict = Verdict(
        "ch02.q4",
        "Vera's health",
        1,
        2,
        expected="at least two topics of different types",
        got="none; it said: ok",
        cause="They have the same type.",
        hint="The namespace `/` ends with the slash that you would add. `rstrip` takes it away.",
        gave="at least 3 m",
    )
    assert verdict.text().splitlines() == [
        "✘ ch02.q4 La salud de Vera: 1 de 2 puntos",
        "  esperado: al menos dos tópicos de tipos distintos",
        "  diste: at least 3 m",
        "  visto: ninguno; dijo: ok",
        "  causa probable: Tienen el mismo tipo.",
        "  pista: El namespace `/` termina con la diagonal que agregarías. `rstrip` la quita.",
    ]
    assert "<code>rstrip</code> la quita" in verdict.html()


def test_a_panel_takes_its_words_along(in_spanish):
    from coursekit.lab.panel import static

    assert r'"look from \"{0}\"": "mirar desde \"{0}\""' in static("viewer.js", "viewer_views.js")
    assert '"Nothing logged yet.": "Todavía no se registra nada."' in static("log.js")
    assert "Nadie publica nada" not in static("log.js")  # another panel's


def test_words_of_a_language_that_nobody_has():
    assert words_of("xx").by_english == {}
