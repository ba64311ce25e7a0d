"""spawn_entity.py with a file that has no name, as an empty launch argument gives it."""

from coursekit.processes.session import Session


def test_an_empty_file_name_is_an_error_and_no_wait_for_the_keyboard() -> None:
    with Session(virtual=True).use() as session:
        from coursekit.processes.executables import find

        process = session.start_executable(find("gazebo_ros", "spawn_entity.py"), ["-entity", "a", "-file", ""])
        assert process.wait(10.0) == 1
        assert "specified file  does not exist" in process.output
