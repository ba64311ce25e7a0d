"""Libraries that compute with threads of their own, on the virtual clock: the session waits for the result."""

from __future__ import annotations

import re

from coursekit.processes.executables import make_process
from tests.nodes.compiled.conftest import program


def test_a_callback_computes_with_openmp_and_the_program_s_own_threads_keep_virtual_time(session, build):
    path = build("parallel", program("parallel.cpp"), "-fopenmp")
    said = []
    for _ in range(2):
        process = session.launch(make_process(session, path, name="parallel"))
        assert process.wait(10.0) == 0, process.output
        said.append(re.findall(r"\]: (.*?) ?([\d.]+)$", process.output, re.MULTILINE))
    words, times = zip(*said[0], strict=True)
    assert words == ("499500 by 4 at", "slept until", "499500 by 4 at", "499500 by 4 at")
    assert [float(time) - float(times[0]) for time in times] == [0.0, 0.5, 1.0, 2.0]
    assert [word for word, _ in said[1]] == list(words)
