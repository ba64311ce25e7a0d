"""The verbs that show and change bags, and what is refused."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.bag.made import all_of
from tests.cli.bag.stage import Stage, write


@pytest.mark.parametrize(
    ("line", "code", "text"),
    [
        ("play nowhere", 2, "argument bag_path: Bag path 'nowhere' does not exist!"),
        ("play talk -r 0", 2, "argument -r/--rate: 0 is not in the valid range (> 0.0)"),
        ("play talk -r x", 2, "x is not the valid type (float)"),
        ("play talk --clock -5", 2, "-5 is not in the valid range (> 0.0)"),
        ("play talk -d -1", 2, "Value -1 is less than zero."),
        ("play talk --wait-for-all-acked -1", 2, "Value -1 is less than zero."),
        ("play empty", 1, "[ERROR] [ros2bag]: there is no metadata.yaml in 'empty'."),
        ("info empty", 1, "'ros2 bag reindex empty' makes one from its files"),
        ("reindex talk/metadata.yaml", 1, "[ERROR] [ros2bag]: Must specify a bag directory"),
        ("reindex empty", 1, "No storage files found for reindexing. Abort"),
        ("convert -i talk -o nowhere.yaml", 1, "'nowhere.yaml' cannot be read: "),
        ("convert -i a b c -o nowhere.yaml", 1, "--input expects 1 or 2 arguments, 3 provided"),
        ("list birds", 2, "argument plugin_type: invalid choice: 'birds'"),
    ],
)
def test_what_cannot_be_is_refused(stage: Stage, line: str, code: int, text: str) -> None:
    Path("empty").mkdir()
    process = stage.ros2(f"bag {line}")
    assert process.wait(5) == code and text in process.output and "Traceback" not in process.output


def test_a_bag_is_shown_in_humbles_layout(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    import time

    monkeypatch.setenv("TZ", "UTC")
    if hasattr(time, "tzset"):  # Windows keeps the zone that the program began with
        time.tzset()
    write("long", 7, max_file_seconds=3, storage_id="sqlite3")
    size = sum(path.stat().st_size for path in Path("long").iterdir()) / 1024
    assert stage.ask("bag info long") == (
        "\n"
        "Files:             long_0.db3\n"
        "                   long_1.db3\n"
        f"Bag size:          {size:.1f} KiB\n"
        "Storage id:        sqlite3\n"
        "Duration:          6.000000000s\n"
        "Start:             Jan  1 1970 00:01:40.000000000 (100.000000000)\n"
        "End:               Jan  1 1970 00:01:46.000000000 (106.000000000)\n"
        "Messages:          7\n"
        "Topic information: Topic: /chatter | Type: std_msgs/msg/String | Count: 7 | Serialization Format: cdr\n"
        "\n"
    )


def test_metadata_is_made_anew_and_bags_are_converted(stage: Stage) -> None:
    before = Path("talk/metadata.yaml").read_text(encoding="utf-8")
    Path("talk/metadata.yaml").unlink()
    said = stage.ask("bag reindex talk")
    assert "[rosbag2_cpp]: Beginning reindexing bag in directory: talk" in said and "Reindexing complete." in said
    assert Path("talk/metadata.yaml").read_text(encoding="utf-8") == before
    Path("out.yaml").write_text("output_bags: [{uri: new, storage_id: mcap, all: true}]", encoding="utf-8")
    stage.ask("bag convert -i talk sqlite3 -o out.yaml")
    assert all_of("new") == all_of("talk") and Path("new/new_0.mcap").exists()


def test_plugins_are_listed(stage: Stage) -> None:
    assert stage.ask("bag list storage") == "mcap\nsqlite3\n"
    assert stage.ask("bag list compressor") == stage.ask("bag list decompressor") == "zstd\n"
    assert "name: sqlite3\n\trosbag2 storage plugin for sqlite3 files\n\ttype: " in stage.ask("bag list storage --verbose")
