"""The installed packages: `ros2 pkg list`, `prefix`, `executables` and `xml`."""

from __future__ import annotations

import argparse
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from ament_index_python import PackageNotFoundError, get_package_prefix, get_packages_with_prefixes

from coursekit.files import read_bytes
from coursekit.interfaces.errors import suggestion
from coursekit.processes.executables import PackageNotFound, executables_of


def _fail(text: str) -> int:
    print(text, file=sys.stderr)
    return 1


def _prefix(package: str) -> Path | None:
    try:
        return Path(get_package_prefix(package))
    except (PackageNotFoundError, ValueError):
        return None


def list_packages(args: argparse.Namespace) -> int:
    """Print the names of all packages, sorted."""
    for name in sorted(get_packages_with_prefixes()):
        print(name)
    return 0


def print_prefix(args: argparse.Namespace) -> int:
    """Print the prefix of a package, or its share folder."""
    prefix = _prefix(args.package_name)
    if prefix is None:
        return _fail("Package not found" + suggestion(args.package_name, get_packages_with_prefixes()))
    print(prefix / "share" / args.package_name if args.share else prefix)
    return 0


def print_executables(args: argparse.Namespace) -> int:
    """Print the executables of one package or of all."""
    names = [args.package_name] if args.package_name else sorted(get_packages_with_prefixes())
    for name in names:
        try:
            paths = executables_of(name)
        except PackageNotFound:
            return _fail(f"Package '{name}' not found{suggestion(name, get_packages_with_prefixes())}")
        for path in paths:
            print(path if args.full_path else f"{name} {path.name}")
    return 0


def print_xml(args: argparse.Namespace) -> int:
    """Print a package.xml, or the text of one of its tags."""
    prefix = _prefix(args.package_name)
    if prefix is None:
        return _fail("Package not found" + suggestion(args.package_name, get_packages_with_prefixes()))
    path = prefix / "share" / args.package_name / "package.xml"
    if not path.is_file():
        return _fail("Package xml manifest not found")
    root = ElementTree.fromstring(read_bytes(path))
    if args.tag is None:
        print(ElementTree.tostring(root, encoding="unicode"))
        return 0
    elements = root.findall(args.tag)
    for element in elements:
        print(element.text)
    return 0 if elements else _fail("XML tag not found")
