"""Files of settings that a compiled program reads with cv::FileStorage, parsed by Python's cv2 and sent as a whole.

The program's end is `cpp/opencv/opencv2/core/file_node.hpp`; what it writes goes to an object of cv2's, call by call.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import cv2


def nodes_of(where: str, flags: int) -> tuple[Any, ...]:
    """Return a file, or with the flag for memory a text, as a tree: each part's type, name, content and matrix."""
    import cv2

    file = cv2.FileStorage(where, flags)
    try:
        return _part(file.root())
    finally:
        file.release()


def _part(node: cv2.FileNode, name: str = "") -> tuple[Any, ...]:
    return (node.type(), name, _content(node), node.mat() if _is_matrix(node) else None)


def _content(node: cv2.FileNode) -> Any:
    if node.isInt():
        return int(node.real())
    if node.isReal():
        return node.real()
    if node.isString():
        return node.string()
    if node.isMap():
        return [_part(node.getNode(key), key) for key in node.keys()]  # noqa: SIM118  # a FileNode is no dict
    return [_part(node.at(place)) for place in range(node.size())] if node.isSeq() else None


def _is_matrix(node: cv2.FileNode) -> bool:
    return node.isMap() and {"dt", "data"} <= set(node.keys())


FACES: dict[str, Callable[..., Any]] = {"file_nodes": nodes_of}
"""The functions by the names that C++ asks for."""
