"""ros2 run gazebo_ros spawn_entity.py"""

import sys

from coursekit.nodes.gazebo.spawn_entity import main

if __name__ == "__main__":
    sys.exit(main())
