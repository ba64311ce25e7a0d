"""`python -m tests.conformance`: the suite on coursekit and on the real rclpy, side by side."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from compare import main

sys.exit(main())
