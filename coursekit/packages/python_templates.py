"""Files of a new ament_python package."""

from __future__ import annotations

from coursekit.packages.package_settings import PackageSettings

_SETUP = """\
from setuptools import find_packages, setup

package_name = '{name}'

setup(
    name=package_name,
    version='0.0.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages',
            ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer={maintainer!r},
    maintainer_email={email!r},
    description={description!r},
    license={license!r},
    tests_require=['pytest'],
    entry_points={{
        'console_scripts': [
{scripts}        ],
    }},
)
"""

NODE = """\
def main():
    print('Hi from {name}.')


if __name__ == '__main__':
    main()
"""

TEST_COPYRIGHT = """\
from ament_copyright.main import main
import pytest


# Take this mark away once every source file starts with a copyright notice
@pytest.mark.skip(reason='The source files that were made have no copyright notice yet.')
@pytest.mark.copyright
@pytest.mark.linter
def test_copyright():
    rc = main(argv=['.', 'test'])
    assert rc == 0, 'Found errors'
"""

TEST_FLAKE8 = """\
from ament_flake8.main import main_with_errors
import pytest


@pytest.mark.flake8
@pytest.mark.linter
def test_flake8():
    rc, errors = main_with_errors(argv=[])
    assert rc == 0, 'Found %d style errors:\\n' % len(errors) + '\\n'.join(errors)
"""

TEST_PEP257 = """\
from ament_pep257.main import main
import pytest


@pytest.mark.linter
@pytest.mark.pep257
def test_pep257():
    rc = main(argv=['.', 'test'])
    assert rc == 0, 'Found docstring errors'
"""

TESTS = {"test_copyright.py": TEST_COPYRIGHT, "test_flake8.py": TEST_FLAKE8, "test_pep257.py": TEST_PEP257}


def setup_py(recipe: PackageSettings) -> str:
    """Return the text of setup.py."""
    script = f"{recipe.node_name} = {recipe.name}.{recipe.node_name}:main" if recipe.node_name else ""
    return _SETUP.format(
        name=recipe.name,
        maintainer=recipe.maintainer_name,
        email=recipe.maintainer_email,
        description=recipe.description,
        license=recipe.license,
        scripts=f"            '{script}',\n" if script else "",
    )


def setup_cfg(recipe: PackageSettings) -> str:
    """Return the text of setup.cfg: executables go where `ros2 run` finds them.

    >>> print(setup_cfg(PackageSettings("robot", "", "MIT", "Ada", "ada@example.com", "ament_python")), end="")
    [develop]
    script_dir=$base/lib/robot
    [install]
    install_scripts=$base/lib/robot
    """
    where = f"$base/lib/{recipe.name}"
    return f"[develop]\nscript_dir={where}\n[install]\ninstall_scripts={where}\n"
