"""`python limited.py MEMORY PROCESSES FILE SECONDS -- COMMAND`: sets the limits, then executes the command."""

import os
import sys


def main(argv: list[str]) -> None:
    """Limit this process and execute the command."""
    memory, processes, file, seconds = (int(word) for word in argv[:4])
    try:
        import resource
    except ImportError:  # Windows: only the watcher outside sets limits
        pass
    else:
        wanted = {
            "RLIMIT_AS": memory,
            "RLIMIT_NPROC": processes,
            "RLIMIT_FSIZE": file,
            "RLIMIT_CPU": 2 * seconds,
            "RLIMIT_CORE": 0,
            "RLIMIT_NOFILE": 512,
        }
        for name, value in wanted.items():
            _, hard = resource.getrlimit(getattr(resource, name))
            most = value if hard == resource.RLIM_INFINITY else min(value, hard)
            resource.setrlimit(getattr(resource, name), (most, most))
    end_with_parent()
    command = argv[argv.index("--") + 1 :]
    os.execvp(command[0], command)


def end_with_parent() -> None:
    """End together with the parent process, if the system supports that."""
    if sys.platform.startswith("linux"):
        import ctypes

        parent_death_signal, kill = 1, 9
        ctypes.CDLL(None).prctl(parent_death_signal, kill)


if __name__ == "__main__":
    main(sys.argv[1:])
