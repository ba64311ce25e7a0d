"""The student's copy: what stands where the solution was."""

import pytest

from coursekit.grade.copy import without_solution

SOLVED = "{head}\n  ### BEGIN SOLUTION\n  secret\n  ### END SOLUTION\nend"


@pytest.mark.parametrize("file", ["src/p/urdf/cart.urdf", "robot.urdf.xacro", "a.launch.xml"])
def test_in_xml_the_stub_is_a_comment(file):
    text = without_solution(SOLVED.format(head=f"%%write {file}"))
    assert text == f"%%write {file}\n  <!-- YOUR CODE HERE -->\nend"


@pytest.mark.parametrize("file", ["src/p/msg/Sphere.msg", "A.srv", "A.action", "src/p/config/a.yaml", "a.yml"])
def test_in_data_the_stub_is_a_comment_alone_which_breaks_no_build(file):
    text = without_solution(SOLVED.format(head=f"%%write {file}"))
    assert text == f"%%write {file}\n  # YOUR CODE HERE\nend"


def test_in_cpp_the_stub_is_a_comment_which_compiles():
    solved = SOLVED.replace("###", "// ###").format(head="%%write -a src/p/src/node.cpp")
    assert without_solution(solved) == "%%write -a src/p/src/node.cpp\n  // YOUR CODE HERE\nend"


@pytest.mark.parametrize("head", ["import math", "%%write src/p/p/node.py"])
def test_elsewhere_the_stub_raises(head):
    text = without_solution(SOLVED.format(head=head))
    assert text == f"{head}\n  # YOUR CODE HERE\n  raise NotImplementedError()\nend"
