"""What the checks of chapter 5 say of parameter files, and of pictures without a ball."""

import pytest

from coursekit.grade.chapters.ch05 import _expect_none
from coursekit.grade.checking import judge
from coursekit.grade.exercise import find
from coursekit.grade.plan import Seen
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work
from tests.grade.tried import Tried

FLEET = """/**:
  ros__parameters:
    use_sim_time: false
/**/py_camera_node:
  ros__parameters:
    camera: {width: 320, height: 240}
/gate/py_camera_node:
  ros__parameters:
    camera: {width: 1280, height: 720}
"""


@pytest.mark.parametrize(
    ("right", "wrong", "cause"),
    [
        ("false", '"false"', "a string is written there; a bool is wanted."),
        ("width: 320", "width: 320.0", "a double is written there; an integer is wanted."),
        ("height: 240}", "height: 240", ""),
        ("    camera: {width: 320", "\tcamera: {width: 320", "YAML is indented with spaces, never with tabs."),
        ("  ros__parameters", "ros__parameters", "Two underscores in ros__parameters"),
    ],
)
def test_the_cause_in_a_parameter_file_is_the_fault_that_is_there(tmp_path, right, wrong, cause):
    file = tmp_path / "src" / "s5_py_camera" / "config" / "fleet.yaml"
    file.parent.mkdir(parents=True)
    file.write_text(FLEET)
    assert judge(find("ch05.q2"), {}, tmp_path, 2).passed
    file.write_text(FLEET.replace(right, wrong, 1))
    said = judge(find("ch05.q2"), {}, tmp_path, 2)
    assert said.cause.startswith(cause) and bool(said.cause) is bool(cause) and not said.hint and not said.passed


@pytest.mark.parametrize(("stamps", "got"), [([1, 2], "picture 1 and picture 2"), ([], "neither")])
def test_a_picture_without_a_ball_has_no_place(stamps, got):
    told = {"/ball/pixel": [(0.5, {"header": {"stamp": {"sec": stamp}}}) for stamp in stamps]}
    with pytest.raises(Wrong) as caught:
        _expect_none(Tried(Seen(messages=told)), Work({}, None).dice("ch05.q4"))
    assert caught.value.got == f"places for {got}"
