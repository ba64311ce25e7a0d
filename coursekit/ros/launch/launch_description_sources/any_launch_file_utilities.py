"""Loads launch files of any format."""

from __future__ import annotations

import os

from ..frontend import Parser
from ..invalid_launch_file_error import InvalidLaunchFileError
from ..launch_description import LaunchDescription
from .frontend_launch_file_utilities import get_launch_description_from_frontend_launch_file
from .python_launch_file_utilities import get_launch_description_from_python_launch_file


def get_launch_description_from_any_launch_file(
    launch_file_path: str, *, parser: type[Parser] = Parser
) -> LaunchDescription:
    """Return the description in a launch file; the file name extension determines the format.

    Raises:
        FileNotFoundError: if there is no such file.
        InvalidLaunchFileError: if it cannot be loaded; the message contains the reason.
    """
    path = str(launch_file_path)
    if not os.path.isfile(path):
        raise FileNotFoundError(2, "launch file does not exist", path)
    ending = os.path.splitext(path)[1][1:]
    try:
        if ending == "py":
            return get_launch_description_from_python_launch_file(path)
        return get_launch_description_from_frontend_launch_file(path, parser=parser)
    except InvalidLaunchFileError:
        raise
    except Exception as error:
        raise InvalidLaunchFileError(ending, likely_errors=[error]) from error
