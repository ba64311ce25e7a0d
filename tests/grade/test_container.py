"""Marking on Windows and macOS: in a container, or not at all. What stands in for podman notes what it is asked."""

import importlib.metadata
import io
import json
import subprocess
import sys
import zipfile

import pytest

from coursekit.cli.coursekit import main
from coursekit.grade import container, container_image, sandbox
from coursekit.systems import operating_system
from tests.needs import ON_WINDOWS, posix

ENGINE = """#!/bin/sh
'''exec' "{python}" "$0" "$@"
''' # sh reads two lines, Python reads a text: a first line of Python's own ends at a space in its path
import json, sys
words = sys.argv[1:]
with open({log!r}, "a", encoding="utf-8") as file:
    file.write(json.dumps(words) + "\\n")
sys.exit({{"info": {info}, "image": 1, "build": {build}, "run": 3}}[words[0]])
"""


@pytest.fixture
def computer(tmp_path, monkeypatch):
    """A Mac whose programs for containers are those given; what they are asked."""
    programs, log = tmp_path / "programs", tmp_path / "asked"
    programs.mkdir()
    monkeypatch.setattr(operating_system, "MAC", True)
    monkeypatch.setenv("PATH", str(programs))
    image = container_image.Image(wheel(), "coursekit-0.1.0-py3-none-any.whl")
    monkeypatch.setattr(container.Image, "of_this_course", classmethod(lambda _: image))
    monkeypatch.setattr(sandbox, "start", lambda *_, **__: pytest.fail("a submission was run outside of the container"))

    def make(*names, info=0, build=0):
        text = ENGINE.format(python=sys.executable, log=str(log), info=info, build=build)
        for name in names:
            file = programs / (f"{name}.py" if ON_WINDOWS else name)
            file.write_text(text)
            file.chmod(0o755)
            if ON_WINDOWS:  # it starts programs by their endings
                (programs / f"{name}.bat").write_text(f'@"{sys.executable}" "{file}" %*\n@exit /b %ERRORLEVEL%\n')

    make.asked = lambda: [json.loads(line) for line in log.read_text().splitlines()]
    make.folder = tmp_path
    (tmp_path / "handed in").mkdir()
    return make


def wheel():
    """A wheel with next to nothing in it."""
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("coursekit/__init__.py", "")
    return file.getvalue()


def graded(computer, *words):
    return main(["grade", str(computer.folder / "handed in"), "--out", str(computer.folder / "out" / "grades.csv"), *words])


def test_where_there_is_no_container_it_refuses_in_a_sentence_that_names_the_ways(computer):
    with pytest.raises(SystemExit) as ended:
        graded(computer)
    assert "nothing that keeps them in" in str(ended.value)
    assert "Docker Desktop" in str(ended.value) and "Podman" in str(ended.value) and "bubblewrap" in str(ended.value)


def test_one_that_does_not_answer_is_none(computer):
    computer("podman", "docker", info=125)
    with pytest.raises(SystemExit, match="nothing that keeps them in"):
        graded(computer)
    assert computer.asked() == [["info"], ["info"]]


def test_windows_marks_nothing_without_walls_whoever_asks(computer, monkeypatch):
    monkeypatch.setattr(operating_system, "WINDOWS", True)
    with pytest.raises(SystemExit, match="nothing that keeps them in"):
        graded(computer, "--unsafe")


def test_a_mac_does_so_only_when_it_is_asked_to(computer, monkeypatch):
    monkeypatch.setattr(operating_system, "WINDOWS", False)
    assert container.refusal(unsafe=True) == "" and container.refusal(unsafe=False)


WORDS = posix("what stands in for podman is a file for cmd there, which takes words apart")


@pytest.fixture
def ran(computer):
    """The words of `podman run` for all that a teacher may say."""
    computer("podman", "docker")
    (computer.folder / "out").mkdir()
    (computer.folder / "lists").mkdir()
    for name in ("names.csv", "late.toml"):
        (computer.folder / "lists" / name).write_text("")
    lists = computer.folder / "lists"
    words = ["--variants", str(lists / "names.csv"), "--policy", str(lists / "late.toml"), "--jobs", "3", "--anonymous"]
    assert graded(computer, *words, "--chapters", "02", "03", "--due", "2026-11-30T23:59", "--again") == 3
    info, inspect, build, run = computer.asked()
    assert (info, inspect[:2], build[:2]) == (["info"], ["image", "inspect"], ["build", "--tag"])
    assert build[2] == inspect[2] and build[2] in run
    return run[: run.index(build[2])], run[run.index(build[2]) + 1 :]


@WORDS
def test_the_grader_inside_gets_the_words_of_the_one_outside_with_paths_as_they_are_there(ran):
    _, words = ran
    due = words.pop(words.index("--due") + 1)
    assert due.startswith("2026-11-30T23:59:00") and due[19:]
    assert words == [
        "grade", "/in/folder", "--variants", "/in/variants/names.csv", "--policy", "/in/policy/late.toml",
        "--out", "/out/grades.csv", "--allow-root", "--anonymous",
        "--jobs", "3", "--due", "--chapters", "02", "03", "--again",
    ]  # fmt: skip


@WORDS
def test_the_command_inside_is_one_that_the_grader_takes(ran, monkeypatch):
    from coursekit.cli import grading

    taken = []
    monkeypatch.setattr(grading, "run_grade", lambda args: taken.append(args))
    main(ran[1])
    assert (taken[0].jobs, taken[0].chapters, taken[0].again, taken[0].anonymous) == (3, ["02", "03"], [], True)


@WORDS
def test_it_has_no_network_no_rights_and_writes_only_results(ran, computer):
    words, _ = ran
    assert words[:2] == ["run", "--rm"]
    for pair in (["--network", "none"], ["--cap-drop", "ALL"], ["--security-opt", "unmask=ALL"]):
        assert any(words[index : index + 2] == pair for index in range(len(words))), pair
    assert "--read-only" in words and "--privileged" not in words
    mounts = [words[index + 1] for index, word in enumerate(words) if word == "--mount"]
    assert mounts == [
        f"type=bind,source={computer.folder / 'handed in'},target=/in/folder,readonly",
        f"type=bind,source={computer.folder / 'lists'},target=/in/variants,readonly",
        f"type=bind,source={computer.folder / 'lists'},target=/in/policy,readonly",
        f"type=bind,source={computer.folder / 'out'},target=/out",
    ]


@WORDS
def test_docker_is_told_in_its_own_words(computer):
    computer("docker")
    (computer.folder / "out").mkdir()
    assert graded(computer) == 3
    assert "systempaths=unconfined" in computer.asked()[-1]


def test_where_the_image_cannot_be_made_nothing_runs(computer):
    computer("podman", build=1)
    (computer.folder / "out").mkdir()
    with pytest.raises(SystemExit, match="image could not be made"):
        graded(computer)
    assert [command[0] for command in computer.asked()] == ["info", "image", "build"]


@pytest.mark.parametrize("name", ["a,readonly=false", *([] if ON_WINDOWS else ['a"b'])])
def test_a_folder_whose_name_would_be_a_word_of_the_mount_is_refused(computer, name):
    computer("podman")
    (computer.folder / name).mkdir()
    with pytest.raises(SystemExit, match="comma or quote"):
        main(["grade", str(computer.folder / name)])
    assert "run" not in [command[0] for command in computer.asked()]


def test_marking_by_hand_is_refused_with_the_reason(computer):
    computer("podman")
    with pytest.raises(SystemExit, match="--review opens a page"):
        graded(computer, "--review")


def test_another_version_is_another_image():
    first, second = container_image.Image(wheel(), "x.whl"), container_image.Image(wheel(), "x.whl", b"numpy==2.0")
    assert first.tag == container_image.Image(wheel(), "x.whl").tag != second.tag


def test_an_installed_package_is_packed_into_the_wheel_that_it_came_from(tmp_path):
    distribution = importlib.metadata.distribution("pluggy")
    (tmp_path / f"pluggy-{distribution.version}-py3-none-any.whl").write_bytes(container_image.packed(distribution))
    [wheel_file] = tmp_path.iterdir()
    command = [sys.executable, "-m", "pip", "install", "-q", "--no-deps", "--no-index", "--target", str(tmp_path / "there")]
    subprocess.run([*command, str(wheel_file)], check=True)
    code = "import pluggy; print(pluggy.__file__)"
    env = {"PYTHONPATH": str(tmp_path / "there")}
    done = subprocess.run([sys.executable, "-c", code], env=env, check=True, capture_output=True, encoding="utf-8")
    assert done.stdout.startswith(str(tmp_path / "there"))
