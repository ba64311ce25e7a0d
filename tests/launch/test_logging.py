"""What launch.logging writes where, and in which form."""

from __future__ import annotations

import logging
import logging.handlers
import re
from pathlib import Path

import launch.logging
import pytest
from launch.logging import get_logger, get_output_loggers, launch_config
from launch.logging.config import shown_log_dir


@pytest.fixture(autouse=True)
def folder(session: object, tmp_path: Path) -> Path:
    launch_config.log_dir = str(tmp_path)
    return tmp_path


def test_the_screen_shows_level_name_and_text(capsys: pytest.CaptureFixture[str]) -> None:
    get_logger("arm").info("ready")
    assert capsys.readouterr().out == "[INFO] [arm]: ready\n"


def test_the_screen_may_show_the_time(capsys: pytest.CaptureFixture[str]) -> None:
    launch_config.set_screen_format("default_with_timestamp")
    get_logger("arm").info("ready")
    assert re.fullmatch(r"1700000000\.0000000 \[INFO\] \[arm\]: ready\n", capsys.readouterr().out)


def test_the_environment_decides_the_forms(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, folder: Path
) -> None:
    monkeypatch.setenv("OVERRIDE_LAUNCH_SCREEN_FORMAT", "{name}: {message}!")
    monkeypatch.setenv("OVERRIDE_LAUNCH_LOG_FORMAT", "{name}\\t{message}")
    launch.logging.reset()
    launch_config.log_dir = str(folder)
    get_logger("arm").info("ready")
    assert capsys.readouterr().out == "arm: ready!\n"
    assert (folder / "launch.log").read_text() == "arm\tready\n"


def test_a_default_form_has_its_own_style() -> None:
    with pytest.raises(ValueError, match="custom format style for the 'default' format"):
        launch_config.set_screen_format("default", screen_style="%")
    with pytest.raises(ValueError, match="'default'"):
        launch_config.set_log_format("default", log_style="%")


def test_the_log_folder_must_be_one(folder: Path) -> None:
    with pytest.raises(ValueError, match="nowhere is not a directory"):
        launch_config.log_dir = str(folder / "nowhere")


def test_each_line_of_a_process_stands_in_the_log_with_its_time_and_in_its_own_log_without(folder: Path) -> None:
    stdout, _ = get_output_loggers("arm-1", {"both": {"log", "own_log"}})
    stdout.info("%s", "one\ntwo {}")
    assert (folder / "launch.log").read_text() == "1700000000.0000000 one\n1700000000.0000000 two {}\n"
    assert (folder / "arm-1.log").read_text() == "one\ntwo {}\n"


@pytest.mark.parametrize("wrong", ["scren", {"garbage": {"log"}}, {"stdout": {"garbage"}}])
def test_an_output_that_is_not_known_is_refused(wrong: object) -> None:
    with pytest.raises(ValueError, match="valid"):
        get_output_loggers("arm-1", wrong)  # type: ignore[arg-type]


def test_files_may_be_written_by_handlers_of_one_s_own() -> None:
    written: list[str] = []

    class Keeper(launch.logging.handlers.Handler):
        def emit(self, record: logging.LogRecord) -> None:
            written.append(self.format(record))

    launch_config.log_handler_factory = lambda path, encoding=None: Keeper()
    get_logger("arm").error("broken")
    assert written == ["1700000000.0000000 [ERROR] [arm]: broken"]


def test_python_s_own_handlers_have_a_format_for_each_logger_too(folder: Path) -> None:
    launch_config.log_handler_factory = lambda path, encoding=None: launch.logging.handlers.RotatingFileHandler(
        path, maxBytes=90, backupCount=1, encoding=encoding
    )
    launch_config.get_log_file_handler().setFormatterFor("leg", logging.Formatter("the leg is %(message)s"))
    for name in ("arm", "leg"):
        get_logger(name).error("broken")
    get_logger("arm").error("mended, at last, after many hours of work")
    assert (folder / "launch.log.1").read_text() == "1700000000.0000000 [ERROR] [arm]: broken\nthe leg is broken\n"
    kept = launch.logging.handlers.MemoryHandler(9)
    assert isinstance(kept, logging.handlers.MemoryHandler)
    assert isinstance(kept, launch.logging.handlers.MemoryHandler)
    with pytest.raises(AttributeError, match="has no attribute 'Formatter'"):
        launch.logging.handlers.Formatter  # noqa: B018


def test_a_launch_of_ones_own_tells_where_its_logs_are(capsys: pytest.CaptureFixture[str]) -> None:
    launch_config.level = logging.WARNING
    logger = get_logger("launch")
    logger.setLevel(logging.INFO)
    launch.logging.log_launch_config(logger=logger)
    assert capsys.readouterr().out.splitlines() == [
        f"[INFO] [launch]: All log files can be found below {shown_log_dir()}",
        "[INFO] [launch]: Default logging verbosity is set to WARNING",
    ]
