"""Creates a new package, as `ros2 pkg create` does."""

from __future__ import annotations

import argparse
import getpass
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from coursekit.packages import cmake_templates, python_templates
from coursekit.packages.package_settings import PackageSettings, manifest
from coursekit.systems.letter_case import other_spelling
from coursekit.words import licenses

BUILD_TYPES = ("cmake", "ament_cmake", "ament_python")
_NAME = re.compile(r"[a-zA-Z][a-zA-Z0-9_-]*")
_PART = re.compile(r"[a-zA-Z0-9_][a-zA-Z0-9_.+-]*")


def add_create_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `ros2 pkg create` to a parser."""
    add = parser.add_argument
    add("package_name", help="The package name")
    add(
        "--package-format",
        "--package_format",
        type=int,
        default=3,
        choices=[2, 3],
        help="The package.xml format.",
    )
    add("--description", default="TODO: Package description", help="The description given in the package.xml")
    add(
        "--license",
        default="TODO: License declaration",
        help="The license of this package ('?' lists the known ones)",
    )
    add("--destination-directory", default=os.curdir, help="Directory where to create the package directory")
    add(
        "--build-type",
        default="ament_cmake",
        choices=BUILD_TYPES,
        help="The build type to process the package with",
    )
    add("--dependencies", nargs="+", default=[], help="list of dependencies")
    add("--maintainer-email", help="email address of the maintainer of this package")
    add("--maintainer-name", default=getpass.getuser(), help="name of the maintainer of this package")
    add("--node-name", help="name of the empty executable")
    add("--library-name", help="name of the empty library")


def create(args: argparse.Namespace) -> int:
    """Create the package and print every step; return 0, or 1 after printing why it was not created."""
    if args.license == "?":
        print("Supported licenses:\n" + "\n".join(licenses.NAMES))
        return 0
    recipe = _recipe(args)
    refusal = _refusal(recipe, args.destination_directory)
    if refusal:
        print(refusal, file=sys.stderr)
        return 1
    _announce(recipe, args.destination_directory)
    _Maker(recipe, args.destination_directory).make()
    return 0


def _recipe(args: argparse.Namespace) -> PackageSettings:
    node_name = args.node_name or None
    if node_name and node_name == args.library_name:
        node_name += "_node"
        print("[WARNING] node name can not be equal to the library name", file=sys.stderr)
        print(f"[WARNING] renaming node to {node_name}", file=sys.stderr)
    return PackageSettings(
        name=args.package_name,
        description=args.description,
        license=args.license,
        maintainer_name=args.maintainer_name,
        maintainer_email=args.maintainer_email or _email(args.maintainer_name),
        build_type=args.build_type,
        dependencies=tuple(args.dependencies),
        package_format=args.package_format,
        node_name=node_name,
        library_name=args.library_name or None,
    )


def _email(name: str) -> str:
    git = shutil.which("git")
    if git is not None:
        asked = [git, "config", "user.email"]
        answer = subprocess.run(asked, capture_output=True, encoding="utf-8", errors="replace", check=False)
        if answer.stdout.strip():
            return answer.stdout.strip()
    return f"{name}@todo.todo"


def _refusal(recipe: PackageSettings, destination: str) -> str | None:
    if recipe.build_type == "ament_python" and recipe.name == "test":
        why = "Aborted since 'ament_python' packages can't be named 'test'."
        return f"{why} Please choose a different package name."
    if not _NAME.fullmatch(recipe.name):
        cure = "use small letters, digits and underscores, as in my_package"
        return f"Aborted! '{recipe.name}' is no package name: {cure}"
    for name in filter(None, (recipe.node_name, recipe.library_name, *recipe.dependencies)):
        if not _PART.fullmatch(name):  # it is written into source code
            cure = "use letters, digits, underscores and hyphens, as in my_node"
            return f"Aborted! {name!r} is no name of a node, a library or a package: {cure}"
    path = os.path.join(destination, recipe.name)
    other = other_spelling(Path(path))
    if other:
        why = f"'{other}' and '{recipe.name}' are one folder here: this computer does not tell small letters from capitals"
        return f"\nAborted!\n{why}. Choose another package name"
    if os.path.exists(path):
        cure = "Either remove the directory or choose a different destination directory or package name"
        return f"\nAborted!\nThe directory already exists: {path}\n{cure}"
    return None


def _announce(recipe: PackageSettings, destination: str) -> None:
    print("going to create a new package")
    print("package name:", recipe.name)
    print("destination directory:", os.path.abspath(destination))
    print("package format:", recipe.package_format)
    print("version: 0.0.0")
    print("description:", recipe.description)
    print("maintainer:", [recipe.maintainer])
    print("licenses:", [recipe.license])
    print("build type:", recipe.build_type)
    print("dependencies:", list(recipe.dependencies))
    if recipe.node_name:
        print("node_name:", recipe.node_name)
    if recipe.library_name:
        print("library_name:", recipe.library_name)


class _Maker:
    """Writes the files and prints their names."""

    def __init__(self, recipe: PackageSettings, destination: str) -> None:
        self.recipe = recipe
        self.folder = self._folder(destination, recipe.name)

    def make(self) -> None:
        self._file(self.folder, "package.xml", manifest(self.recipe))
        if self.recipe.build_type == "ament_python":
            self._python()
        else:
            self._cmake()
        self._license()

    def _folder(self, base: str, name: str) -> str:
        path = os.path.join(base, name)
        print("creating folder", path)
        os.makedirs(path, exist_ok=True)
        return path

    def _file(self, folder: str, name: str, text: str) -> None:
        path = os.path.join(folder, name)
        print("creating", path)
        Path(path).write_text(text, encoding="utf-8")

    def _python(self) -> None:
        recipe = self.recipe
        print("creating source folder")
        source = self._folder(self.folder, recipe.name)
        self._file(self.folder, "setup.py", python_templates.setup_py(recipe))
        self._file(self.folder, "setup.cfg", python_templates.setup_cfg(recipe))
        self._file(self._folder(self.folder, "resource"), recipe.name, "")
        self._file(source, "__init__.py", "")
        tests = self._folder(self.folder, "test")
        for name, text in python_templates.TESTS.items():
            self._file(tests, name, text)
        if recipe.node_name:
            self._file(source, f"{recipe.node_name}.py", python_templates.NODE.format(name=recipe.name))
        if recipe.library_name:
            self._file(self._folder(source, recipe.library_name), "__init__.py", "")

    def _cmake(self) -> None:
        recipe = self.recipe
        print("creating source and include folder")
        source = self._folder(self.folder, "src")
        include = self._folder(os.path.join(self.folder, "include"), recipe.name)
        self._file(self.folder, "CMakeLists.txt", cmake_templates.cmake_lists(recipe))
        if recipe.build_type == "cmake":
            self._file(self.folder, f"{recipe.name}Config.cmake.in", cmake_templates.config_in(recipe))
            self._file(self.folder, f"{recipe.name}ConfigVersion.cmake.in", cmake_templates.version_in(recipe))
        if recipe.node_name:
            self._file(source, f"{recipe.node_name}.cpp", cmake_templates.node_cpp(recipe))
        if recipe.library_name:
            self._file(include, f"{recipe.library_name}.hpp", cmake_templates.library_hpp(recipe))
            self._file(source, f"{recipe.library_name}.cpp", cmake_templates.library_cpp(recipe))
            self._file(include, "visibility_control.h", cmake_templates.visibility_h(recipe))

    def _license(self) -> None:
        text = licenses.text(self.recipe.license)
        if text is not None:
            (Path(self.folder) / "LICENSE").write_text(text, encoding="utf-8")
            return
        print(
            f"\n[WARNING]: Unknown license '{self.recipe.license}'.  "
            "This has been set in the package.xml, but "
            "no LICENSE file has been created.\nIt is recommended to use one of the ament license "
            "identitifers:\n" + "\n".join(licenses.NAMES)
        )
