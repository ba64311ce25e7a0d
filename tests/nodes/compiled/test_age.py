"""A compiled program of another version of coursekit is told to be built again; it would not understand this one."""

from __future__ import annotations

from coursekit.cpp.age import MARK, is_of_another_age
from coursekit.processes.executables import make_process

PROGRAM = """
#include "rclcpp/rclcpp.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  std::cout << "up to date" << std::endl;
}
"""
TOLD = (
    "[coursekit] old was built by another version of coursekit than this one, and cannot talk with it. Build its "
    "workspace again: `colcon build`.\n"
)


def test_one_of_this_version_runs(session, build):
    process = session.launch(make_process(session, build("fresh", PROGRAM), name="fresh"))
    assert process.wait(10.0) == 0
    assert process.output == "up to date\n"


def test_one_of_another_version_is_told(session, build, tmp_path):
    fresh = build("fresh", PROGRAM)
    data, old = fresh.read_bytes(), tmp_path / "old"
    at = data.index(MARK) + len(MARK)
    for changed in (data[:at] + b"0" * 16 + data[at + 16 :], data.replace(MARK, b"x" * len(MARK))):
        old.write_bytes(changed)
        old.chmod(0o755)
        assert is_of_another_age(old) and not is_of_another_age(fresh)
        process = session.launch(make_process(session, old, name="old"))
        assert process.wait(10.0) == 1
        assert process.output == TOLD
