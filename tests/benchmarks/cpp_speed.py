"""C++ to C++ on the wall clock: 1000 small messages a second, and images at 30 Hz; prints JSON, null without a compiler."""

import json
import resource
import subprocess
import tempfile
from pathlib import Path

from coursekit.cpp.runtime import ROOM, make_runtime, runtime_folder
from coursekit.cpp.toolchain import NoToolchain, Toolchain, find_toolchain
from coursekit.processes.executables import make_process
from coursekit.processes.session import Session

SOURCE = Path(__file__).parent / "cpp_speed.cpp"


def compiled(tools: Toolchain, folder: Path) -> Path:
    """The program of which two are measured."""
    runtime = runtime_folder(tools)
    if not runtime.is_dir():
        make_runtime(runtime, tools)
    library = ["-Wl,--whole-archive", str(runtime / "lib" / "libcoursekit.a"), "-Wl,--no-whole-archive", "-ldl", "-lpthread"]
    words = ["-std=gnu++17", "-O2", f"-I{ROOM / 'include'}", f"-I{runtime / 'include'}", str(SOURCE)]
    subprocess.run([*tools.cxx, *words, "-o", str(folder / "speed"), *library], check=True)
    return folder / "speed"


def _seconds(who: int) -> float:
    used = resource.getrusage(who)
    return used.ru_utime + used.ru_stime


def measured(program: Path, count: int, rate: float, size: int) -> dict[str, float]:
    """How many came, how late (µs), whether the sender fell behind, and the share of a core that the session used."""
    with (session := Session(virtual=False)).use():
        ears = session.launch(make_process(session, program, ["hear", str(count)], name="hear"))
        before = _seconds(resource.RUSAGE_SELF)
        sender = session.launch(make_process(session, program, ["send", str(count), str(rate), str(size)], name="send"))
        ended = ears.wait(count / rate * 4 + 20), sender.wait(20.0)
        used = _seconds(resource.RUSAGE_SELF) - before
    assert ended == (0, 0), ears.output + sender.output
    came, median, late = (float(word) for word in ears.output.split())
    return {
        "came": came,
        "median": median,
        "99": late,
        "behind": float(sender.output),
        "core": used / (count / rate),
    }


def main() -> None:
    """Measure and print."""
    try:
        tools = find_toolchain()
    except NoToolchain:
        print("null")
        return
    with tempfile.TemporaryDirectory() as name:
        program = compiled(tools, Path(name))
        small, image = measured(program, 5000, 1000.0, 64), measured(program, 150, 30.0, 640 * 480 * 3)
        print(json.dumps({"small": small, "image": image}))


if __name__ == "__main__":
    main()
