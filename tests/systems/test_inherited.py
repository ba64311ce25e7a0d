"""A child is given pipes beside the usual three, on every system."""

import os
import subprocess
import sys

CHILD = """
import os, sys
from coursekit.systems.inherited import opened
read, write = map(opened, sys.argv[1:])
os.write(write, os.read(read, 100).upper())
"""


def test_a_child_reads_and_writes_pipes_that_it_is_given():
    from coursekit.systems import inherited

    there, back = os.pipe(), os.pipe()
    try:
        words = [sys.executable, "-c", CHILD, inherited.name_for_child(there[0]), inherited.name_for_child(back[1])]
        own = inherited.given((there[0], back[1]))
        child = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, **own)
        os.write(there[1], b"\r\n\x1a word")
        assert os.read(back[0], 100) == b"\r\n\x1a WORD"
        child.communicate()
        assert child.returncode == 0
    finally:
        for descriptor in (*there, *back):
            os.close(descriptor)
