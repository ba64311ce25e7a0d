"""ros2 run controller_manager unspawner.py"""

import sys

from coursekit.nodes.control.unspawner import main

if __name__ == "__main__":
    sys.exit(main())
