"""A new file in an old one's place, also while another program reads the old one for a moment."""

from __future__ import annotations

import os
import time

from . import which

PAUSES = (0.01, 0.02, 0.05, 0.1, 0.2, 0.4, 0.8)
"""How long to wait between two tries [s]."""


def put_in_place(fresh: str | os.PathLike[str], target: str | os.PathLike[str]) -> None:
    """Rename a file, over the old one if there is one.

    Windows refuses that while a program has the old file open: a scanner of viruses, a disk in the cloud, a viewer. They
    are done in a moment, and it is tried again. PermissionError, which says so, when they are not.
    """
    for pause in PAUSES if which.WINDOWS else ():
        try:
            os.replace(fresh, target)
            return
        except PermissionError:
            time.sleep(pause)
    try:
        os.replace(fresh, target)
    except PermissionError as error:
        if which.WINDOWS:
            error.strerror = "Another program has the file open: close it, and try again"
        raise
