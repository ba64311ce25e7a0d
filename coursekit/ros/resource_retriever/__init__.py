"""Files by their addresses: package://, file://, http://.

In ROS 2: the Python module of the package resource_retriever.
"""

from __future__ import annotations

from pathlib import Path
from urllib.error import URLError
from urllib.request import urlopen

from ament_index_python.packages import get_package_share_directory

__all__ = ["PACKAGE_PREFIX", "get", "get_filename"]
PACKAGE_PREFIX = "package://"


def get_filename(url: str, use_protocol: bool = True) -> str:
    """Return the file that a package:// address means, as a file:// address or as a path; other addresses unchanged.

    Raises ValueError for a package:// address without a path, PackageNotFoundError for an unknown package.

    >>> get_filename("package://turtlesim/package.xml").startswith("file://")
    True
    >>> get_filename("http://robot.local/arm.stl")
    'http://robot.local/arm.stl'
    """
    if not url.startswith(PACKAGE_PREFIX):
        return url
    package, slash, rest = url.removeprefix(PACKAGE_PREFIX).partition("/")
    if not slash:
        raise ValueError(f"Could not parse package:// format into file:// format for {url}")
    path = Path(get_package_share_directory(package), rest)
    return path.as_uri() if use_protocol else str(path)


def get(url: str) -> bytes:
    """Return what an address leads to. Raises ValueError where nothing can be read there, and as `get_filename`.

    >>> get("package://turtlesim/package.xml")[:5]
    b'<?xml'
    """
    address = get_filename(url)
    try:
        with urlopen(address) as answer:
            content: bytes = answer.read()
            return content
    except (URLError, OSError) as error:
        raise ValueError(f"Could not retrieve resource at URL: {address}") from error
