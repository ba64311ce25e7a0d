"""Assigns CMake packages to our build step where there is no real ROS, and reports invalid package.xml files."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from catkin_pkg.package import InvalidPackage, has_ros_schema_reference, parse_package
from colcon_core.logging import colcon_logger
from colcon_core.package_augmentation import PackageAugmentationExtensionPoint
from colcon_core.package_identification import PackageIdentificationExtensionPoint
from colcon_core.plugin_system import satisfies_version

from coursekit.packages.colcon_task import PACKAGE_TYPE

logger = colcon_logger.getChild("coursekit")
_CMAKE_TYPES = ("ros.ament_cmake", "ros.cmake", "ros.catkin", "cmake")


def real_ros_is_sourced() -> bool:
    """Return whether a sourced ROS can build CMake packages itself."""
    paths = os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep)
    return any(path and (Path(path) / "share" / "ament_cmake" / "cmake").is_dir() for path in paths)


class FilesAugmentation(PackageAugmentationExtensionPoint):  # type: ignore[misc]
    """Assigns a package to our build step, once everything is known of it."""

    PRIORITY = 50  # after colcon-ros

    def __init__(self) -> None:
        super().__init__()
        satisfies_version(PackageAugmentationExtensionPoint.EXTENSION_POINT_VERSION, "^1.0")

    def augment_package(self, desc: Any, *, additional_argument_names: Any = None) -> None:
        """Change the type of a CMake package and store its groups."""
        building = additional_argument_names is not None  # `colcon list` and `info` show the original type
        if not building or desc.type not in _CMAKE_TYPES or real_ros_is_sourced():
            return
        if (desc.path / "package.xml").is_file():
            try:
                groups = parse_package(str(desc.path)).member_of_groups
                desc.metadata["member_of_groups"] = [group.name for group in groups]
            except (AssertionError, InvalidPackage) as error:
                desc.metadata["manifest_error"] = str(error)
        desc.type = PACKAGE_TYPE


class ManifestIdentification(PackageIdentificationExtensionPoint):  # type: ignore[misc]
    """Reports errors in a package.xml that colcon-ros would silently ignore."""

    PRIORITY = 160  # before colcon-ros

    def __init__(self) -> None:
        super().__init__()
        satisfies_version(PackageIdentificationExtensionPoint.EXTENSION_POINT_VERSION, "^1.0")

    def identify(self, desc: Any) -> None:
        """Only warn; identify nothing."""
        path = str(desc.path)
        if not (desc.path / "package.xml").is_file() or has_ros_schema_reference(path):
            return  # colcon-ros itself warns if the file names ROS's schema
        try:
            parse_package(path)
        except (AssertionError, InvalidPackage) as error:
            logger.warning(f"Failed to parse ROS package manifest in '{path}': {error}")
