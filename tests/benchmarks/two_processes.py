"""`two_processes.py PYTHON [ours]`: a String and an image from one process to another; prints JSON (µs, median).

Ours join a router on loopback, as two notebooks do. The real ones have no network but loopback; Fast DDS shares memory.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

PROGRAM = Path(__file__).parent / "one_way.py"
COUNTS = {"string": 1000, "image": 150}


def measured(python: str, kind: str, env: dict[str, str]) -> float:
    """How long a message takes."""
    words = [kind, str(COUNTS[kind])]
    ears = subprocess.Popen([python, str(PROGRAM), "hear", *words], env=env, stdout=subprocess.PIPE, encoding="utf-8")
    mouth = subprocess.Popen([python, str(PROGRAM), "say", *words], env=env, stdout=subprocess.DEVNULL)
    told, _ = ears.communicate(timeout=120)
    mouth.terminate()
    mouth.wait()
    return float(json.loads(told.splitlines()[-1]))


def main() -> None:
    """Measure and print."""
    python, env = sys.argv[1], dict(os.environ, ROS_DOMAIN_ID="43")
    if sys.argv[2:] != ["ours"]:
        print(json.dumps({kind: measured(python, kind, env) for kind in COUNTS}))
        return
    from coursekit.net.zenoh_session import open_router
    from coursekit.systems.ports import free_port

    address = f"tcp/127.0.0.1:{free_port()}"
    router = open_router([address])
    try:
        env |= {"COURSEKIT_NETWORK": address, "COURSEKIT_ALONE": "1"}
        print(json.dumps({kind: measured(python, kind, env) for kind in COUNTS}))
    finally:
        router.close()


if __name__ == "__main__":
    main()
