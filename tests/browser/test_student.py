"""A student's way: open a chapter, solve an exercise, see the feedback, fail one, save, hand in."""

import zipfile

import pytest

from coursekit.grade.bundle import bundle_faults, read_bundle

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(420)]
PATIENCE_MS = 120_000
WRITE = """([name, text]) => {
    const cells = jupyterapp.shell.currentWidget.content.widgets;
    const cell = cells.find((one) => one.model.getMetadata('nbgrader')?.grade_id === name);
    cell.model.sharedModel.setSource(text);
}"""
RUN = """async (name) => {
    const content = jupyterapp.shell.currentWidget.content;
    const named = (one) => one.model.getMetadata('nbgrader')?.grade_id === name;
    content.activeCellIndex = content.widgets.findIndex(named);
    content.deselectAll();
    await jupyterapp.commands.execute('notebook:run-cell');
}"""
ADD = """async (text) => {
    const content = jupyterapp.shell.currentWidget.content;
    content.activeCellIndex = content.widgets.length - 1;
    content.deselectAll();
    await jupyterapp.commands.execute('notebook:insert-cell-below');
    content.activeCell.model.sharedModel.setSource(text);
}"""
RUN_LAST = "async () => { await jupyterapp.commands.execute('notebook:run-cell'); }"
SAVE = "async () => { await jupyterapp.commands.execute('docmanager:save'); }"


def test_a_student_solves_one_fails_one_and_hands_in(chapter, picture):
    opened = chapter("00_start_here.ipynb")
    page = opened.page
    assert opened.run_to("from coursekit.lab") >= 0

    page.evaluate(WRITE, ["ch00-q1", 'me = "Vera Course"'])
    page.evaluate(RUN, "ch00-q1")
    page.evaluate(RUN, "ch00-q1-check")
    right = page.locator(".jp-OutputArea-output", has_text="ch00.q1 Who are you?: 1 of 1 point")
    right.wait_for(timeout=PATIENCE_MS)
    assert "✔" in right.inner_text()

    page.evaluate(WRITE, ["ch00-q3", 'wishes = {1: "too short"}'])
    page.evaluate(RUN, "ch00-q3")
    page.evaluate(RUN, "ch00-q3-check")
    wrong = page.locator(".jp-OutputArea-output", has_text="ch00.q3 What for?: 0 of 1 point")
    wrong.wait_for(timeout=PATIENCE_MS)
    assert "✘" in wrong.inner_text() and "a sentence for at least three chapters" in wrong.inner_text()
    picture(page, "student-checks")

    page.evaluate(ADD, "hand_in()")
    page.evaluate(RUN_LAST)
    page.locator(".jp-OutputArea-output", has_text="press Ctrl+S").wait_for(timeout=PATIENCE_MS)
    page.evaluate(SAVE)
    page.evaluate(RUN_LAST)
    done = page.locator(".jp-OutputArea-output", has_text="Hand in: VeraCourse_00_start_here.zip")
    try:
        done.wait_for(timeout=60_000)
    except Exception:
        raise AssertionError(opened.text()[-1500:]) from None
    picture(page, "student-hands-in")
    file = next(opened.lab.folder.rglob("VeraCourse_00_start_here.zip"))
    assert bundle_faults(file.read_bytes()) == [] and zipfile.is_zipfile(file)
    manifest, _ = read_bundle(file.read_bytes())
    points = {verdict["name"]: verdict["points"] for verdict in manifest["verdicts"]}
    assert (points["ch00.q1"], points["ch00.q3"]) == (1, 0)
    assert f"({sum(points.values()):g} of 4 points in a clean run)" in done.inner_text()
