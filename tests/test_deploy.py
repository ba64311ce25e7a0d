"""The files for servers fit the course: they name what there is, and one definition is behind them all."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest
import yaml
from traitlets.config.loader import PyFileConfigLoader

from coursekit.cli.coursekit import main
from tests.needs import posix

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).resolve().parents[1]
DEPLOY = ROOT / "deploy"
DOCKERFILE = DEPLOY / "Dockerfile"


def read(file):
    return file.read_text(encoding="utf-8")


def test_binder_and_codespaces_build_the_one_image():
    assert (ROOT / ".binder" / "Dockerfile").resolve() == DOCKERFILE
    build = json.loads(read(ROOT / ".devcontainer" / "devcontainer.json"))["build"]
    assert (ROOT / ".devcontainer" / build["dockerfile"]).resolve() == DOCKERFILE
    assert (ROOT / ".devcontainer" / build["context"]).resolve() == ROOT


def test_nothing_of_the_checkout_but_the_wheel_is_in_the_image_s_layers():
    image = read(DOCKERFILE).rpartition("\nFROM ")[2]
    brought = [line for line in image.splitlines() if line.startswith(("COPY", "ADD"))]
    assert brought == ["COPY --from=wheel /wheels /tmp/wheels"]


def test_the_configuration_starts_the_course_and_names_an_exchange_where_there_is_one(monkeypatch):
    monkeypatch.delenv("COURSEKIT_EXCHANGE", raising=False)
    spawner = PyFileConfigLoader(str(DEPLOY / "hub_config.py")).load_config().Spawner
    assert (Path(spawner.cmd[0]).stem, spawner.cmd[1:]) == ("coursekit", ["hub-lab", "--"])
    assert set(spawner.environment) == {"COURSEKIT_SHARED"}
    monkeypatch.setenv("COURSEKIT_EXCHANGE", "/srv/exchange/ros2")
    spawner = PyFileConfigLoader(str(DEPLOY / "hub_config.py")).load_config().Spawner
    assert spawner.environment["COURSEKIT_EXCHANGE"] == "/srv/exchange/ros2"


@pytest.mark.parametrize("file", ["Dockerfile", "tljh.sh", "hub_config.py"])
def test_commands_extras_and_files_that_are_named_exist(file, capsys):
    text = read(DEPLOY / file)
    for command in set(re.findall(r"coursekit\"?,? \"?(hub-\w+)", text)):
        with pytest.raises(SystemExit, match="0"):
            main([command, "--help"])
    extras = tomllib.loads(read(ROOT / "pyproject.toml"))["project"]["optional-dependencies"]
    for named in re.findall(r"(?:\$1|\.)\[([a-z,]+)\]", text):
        assert set(named.split(",")) <= set(extras)
    assert all((ROOT / path).exists() for path in re.findall(r"deploy/[\w.]+", text))


def test_kubernetes_values_name_files_that_exist():
    text = read(DEPLOY / "values.yaml")
    assert yaml.safe_load(text)["singleuser"]["image"]["name"] == "coursekit"
    assert all((ROOT / path).is_file() for path in re.findall(r"deploy/[\w.]+", text))


@posix("The Littlest JupyterHub is installed on Linux")
def test_the_script_for_the_littlest_jupyterhub_refuses_where_there_is_none():
    done = subprocess.run(["bash", str(DEPLOY / "tljh.sh")], capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 1
    assert "install The Littlest JupyterHub first" in done.stderr
