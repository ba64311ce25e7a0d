"""A new package: the settings of `ros2 pkg create`."""

from __future__ import annotations

from dataclasses import dataclass
from xml.sax.saxutils import escape, quoteattr

_SCHEMA = "http://download.ros.org/schema/package_format{}.xsd"


@dataclass(frozen=True)
class PackageSettings:
    """Name, maintainer, build type and contents of a new package."""

    name: str
    description: str
    license: str
    maintainer_name: str
    maintainer_email: str
    build_type: str
    dependencies: tuple[str, ...] = ()
    package_format: int = 3
    node_name: str | None = None
    library_name: str | None = None

    @property
    def maintainer(self) -> str:
        """E.g. 'Ada <ada@example.com>'."""
        return f"{self.maintainer_name} <{self.maintainer_email}>"

    def buildtools(self) -> list[str]:
        """Return the build tools on which the package depends.

        >>> PackageSettings("robot", "", "MIT", "Ada", "ada@example.com", "ament_cmake", library_name="robot").buildtools()
        ['ament_cmake_ros']
        """
        if self.build_type != "ament_cmake":
            return []
        return ["ament_cmake_ros"] if self.library_name else ["ament_cmake"]

    def test_dependencies(self) -> list[str]:
        """Return the test dependencies of the package."""
        if self.build_type == "ament_cmake":
            return ["ament_lint_auto", "ament_lint_common"]
        if self.build_type == "ament_python":
            return ["ament_copyright", "ament_flake8", "ament_pep257", "python3-pytest"]
        return []


def manifest(recipe: PackageSettings) -> str:
    """Return the text of package.xml.

    >>> recipe = PackageSettings("robot", "Drives & sees", "MIT", "Ada", "ada@example.com", "ament_python", ("rclpy",))
    >>> [line.strip() for line in manifest(recipe).splitlines() if "Drives" in line or "rclpy" in line]
    ['<description>Drives &amp; sees</description>', '<depend>rclpy</depend>']
    """
    email = quoteattr(recipe.maintainer_email)
    schema = _SCHEMA.format(recipe.package_format)
    lines = [
        '<?xml version="1.0"?>',
        f'<?xml-model href="{schema}" schematypens="http://www.w3.org/2001/XMLSchema"?>',
        f'<package format="{recipe.package_format}">',
        f"  <name>{recipe.name}</name>",
        "  <version>0.0.0</version>",
        f"  <description>{escape(recipe.description)}</description>",
        f"  <maintainer email={email}>{escape(recipe.maintainer_name)}</maintainer>",
        f"  <license>{escape(recipe.license)}</license>",
        "",
    ]
    groups = (
        ("buildtool_depend", recipe.buildtools()),
        ("depend", list(recipe.dependencies)),
        ("test_depend", recipe.test_dependencies()),
    )
    for tag, names in groups:
        if names:
            lines += [*(f"  <{tag}>{escape(name)}</{tag}>" for name in names), ""]
    lines += [
        "  <export>",
        f"    <build_type>{recipe.build_type}</build_type>",
        "  </export>",
        "</package>",
        "",
    ]
    return "\n".join(lines)
