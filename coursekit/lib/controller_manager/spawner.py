"""ros2 run controller_manager spawner.py"""

import sys

from coursekit.nodes.control.spawner import main

if __name__ == "__main__":
    sys.exit(main())
