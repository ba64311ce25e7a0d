"""The command `ament_index`: the installed resources, their prefixes and their content."""

from __future__ import annotations

import argparse
import os
import sys
from typing import TYPE_CHECKING, Any

from ament_index_python.resources import get_resource, get_resource_types, get_resources

if TYPE_CHECKING:
    from argparse import Namespace


def main(argv: list[str] | None = None) -> str | None:
    """Print resource types, the resources of a type with their prefixes, or one resource; return an error or None."""
    parser = argparse.ArgumentParser(
        prog="ament_index", description="Query the ament resource index.", formatter_class=argparse.RawTextHelpFormatter
    )
    kind = parser.add_argument("resource_type", nargs="?", help="Print all resources of this type")
    kind.completer = resource_type_completer  # type: ignore[attr-defined]
    name = parser.add_argument("resource_name", nargs="?", help="Print this resource")
    name.completer = resource_name_completer  # type: ignore[attr-defined]
    _complete(parser)
    args = parser.parse_args(argv if argv is not None else [])
    if args.resource_type is None:
        print("\n".join(sorted(get_resource_types())))
    elif args.resource_name is None:
        for resource, prefix in sorted(get_resources(args.resource_type).items()):
            print(f"{resource}\t{prefix}")
    else:
        return _print_one(args.resource_type, args.resource_name)
    return None


def _print_one(resource_type: str, resource_name: str) -> str | None:
    try:
        content, prefix = get_resource(resource_type, resource_name)
    except LookupError:
        return f"Could not find the resource '{resource_name}' of type '{resource_type}'"
    print(prefix)
    if content:
        print(f"<<<\n{content}\n>>>")
    return None


def _complete(parser: argparse.ArgumentParser) -> None:
    if "_ARGCOMPLETE" in os.environ:
        import argcomplete

        argcomplete.autocomplete(parser, exclude=["-h", "--help"])


def resource_type_completer(prefix: str, **kwargs: Any) -> list[str]:
    """Return the resource types that begin with `prefix`."""
    return [name for name in get_resource_types() if name.startswith(prefix)]


def resource_name_completer(prefix: str, parsed_args: Namespace, **kwargs: Any) -> list[str]:
    """Return the resources of the type given before that begin with `prefix`."""
    if not getattr(parsed_args, "resource_type", None):
        return []
    return [name for name in get_resources(parsed_args.resource_type) if name.startswith(prefix)]


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
