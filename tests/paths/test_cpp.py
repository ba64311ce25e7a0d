"""C++ in folders whose names hold quotes and commands: compiled where CMake can, else told in one sentence."""

import pytest

from coursekit.cpp.toolchain import NoToolchain, find_toolchain
from tests.needs import posix
from tests.paths.workspace import HOSTILE, type_in

pytestmark = [pytest.mark.slow, pytest.mark.timeout(240), posix("bash reads what is typed there")]
CREATE = """
cd src; ros2 pkg create says_cpp --build-type ament_cmake --node-name says --maintainer-email ada@example.com
echo 'install(FILES package.xml DESTINATION share/${PROJECT_NAME}/kept)' > line
sed -i '/^ament_package/e cat line' says_cpp/CMakeLists.txt
"""
BUILD = "colcon build; . install/setup.bash; ros2 pkg prefix says_cpp"
READ_BY_CMAKE = "ñ o' $(touch PWNED) `touch PWNED` %d & #x"


@pytest.fixture
def workspace(tmp_path, request):
    """A workspace with a package of C++ in a folder of that name, and that nothing in the name was run."""
    folder = tmp_path / request.param / "ws"
    (folder / "src").mkdir(parents=True)
    type_in(folder, CREATE)
    yield folder
    assert not list(tmp_path.rglob("PWNED*"))


@pytest.mark.parametrize("workspace", [READ_BY_CMAKE], indirect=True)
def test_cpp_is_compiled_and_run_below_names_with_commands_and_quotes(workspace):
    try:
        find_toolchain()
    except NoToolchain as error:
        pytest.skip(str(error))
    said = type_in(workspace, f"{BUILD}; ros2 run says_cpp says")
    assert "hello world says_cpp package" in said, said


@pytest.mark.parametrize("workspace", [HOSTILE], indirect=True)
def test_below_a_name_that_cmake_cannot_read_that_is_said_and_the_rest_is_installed(workspace):
    said = type_in(workspace, BUILD)
    [line] = [line for line in said.splitlines() if "no C++ can be compiled in" in line]
    assert line.endswith("in the name of a folder, so rename it; the rest is installed)"), said
    assert "CMake Error" not in said and "1 package finished" in said, said
    assert (workspace / "install" / "says_cpp" / "share" / "says_cpp" / "kept" / "package.xml").is_file()
