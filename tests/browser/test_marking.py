"""A teacher marks a class by hand in the browser, with the keyboard alone."""

import pytest

from tests.browser.pages import open_page
from tests.grade.handed import rows
from tests.grade.reviewing import make_class, reviewing

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(300)]


def test_a_class_is_marked_by_the_keyboard(browser, tmp_path, picture):
    make_class(tmp_path / "class")
    with reviewing(tmp_path / "class") as address:
        page = open_page(browser, 1366, 768)
        faults = []
        page.on("console", lambda said: faults.append(said.text) if said.type == "error" else None)
        page.on("pageerror", lambda error: faults.append(str(error)))
        page.goto(address)
        picture(page, "class")
        page.keyboard.press("j")
        assert page.evaluate("document.activeElement.textContent") == "Ann Lee"
        page.keyboard.press("Enter")
        page.wait_for_selector("form.marks")
        assert page.evaluate("document.querySelector('.evidence img').naturalWidth") == 1
        page.keyboard.press("n")
        page.keyboard.type("0.5")
        page.keyboard.press("c")
        page.keyboard.type("Jump over it, then <b>n</b>.")
        page.keyboard.press("Enter")
        page.wait_for_selector("#saved:text-is('Saved')")
        page.wait_for_selector("form[data-exercise='ch02.q2'] input:focus")
        assert "0.5 of 1 point" in page.inner_text("[id='ch02.q1'] .said")
        picture(page, "marking")
        where = page.evaluate("location.hash")
        page.keyboard.press("j")
        page.wait_for_selector("h1:text-is('Ben Ito')")
        assert page.evaluate("location.hash") == where == "#at=ch02.q2" and page.title() != "mine"
        page.wait_for_selector("form[data-exercise='ch02.q2'] input:focus")
        page.keyboard.type("1..5")
        page.keyboard.press("Enter")
        page.wait_for_selector("#saved.wrong")
        page.reload()
        page.wait_for_selector("form[data-exercise='ch02.q2'] input:focus")
        page.keyboard.press("j")
        page.wait_for_selector("h1:text-is('Bo Ahn')")
        page.keyboard.press("k")
        page.wait_for_selector("h1:text-is('Ben Ito')")
        page.keyboard.press("k")
        page.wait_for_selector("h1:text-is('Ann Lee')")
        assert page.input_value("form[data-exercise='ch02.q1'] input") == "0.5"
        page.keyboard.press("u")
        page.wait_for_selector("#everybody")
        page.close()
        assert not faults
    row = rows(tmp_path / "grades.csv")["Ann Lee"]
    assert row["total"] == "2.5" and row["ch02.q1"] == "0.5"
    assert "Jump over it, then <b>n</b>." in row.values()
