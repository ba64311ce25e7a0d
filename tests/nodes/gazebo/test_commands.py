"""Launch files that start the simulator as a program."""

from coursekit.cli.parser import run
from coursekit.processes.session import Session

LAUNCH = """
from launch import LaunchDescription
from launch.actions import ExecuteProcess

def generate_launch_description():
    words = ['gazebo', '--verbose', '-s', 'libgazebo_ros_init.so', '-s', 'libgazebo_ros_factory.so', 'office']
    return LaunchDescription([
        ExecuteProcess(cmd=words, output='screen'),
        ExecuteProcess(cmd=['gzclient'], output='screen'),
    ])
"""


def test_a_launch_file_starts_gazebo_by_its_name(tmp_path):
    path = tmp_path / "world.launch.py"
    path.write_text(LAUNCH)
    with Session(virtual=True).use() as session:
        launch = session.start(lambda: run(["launch", str(path)]), name="ros2")
        session.clock.sleep(2)
        names = session.start(lambda: run(["service", "list"]), name="ros2")
        names.wait(5)
        assert "/spawn_entity" in names.output.split()
        assert launch.state == "running" and "world_view()" in launch.output
        launch.interrupt()
        assert launch.wait(10) == 0
