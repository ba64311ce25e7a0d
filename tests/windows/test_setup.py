"""What is set up is reused when it is whole, and only then."""

import pytest

from tests.windows import setup, windows_python


def test_a_set_up_that_was_interrupted_is_made_again(tmp_path, monkeypatch):
    monkeypatch.setattr(setup.wine, "HOME", tmp_path)
    monkeypatch.setattr(setup, "_stamp", tmp_path / "stamp")
    (tmp_path / "stamp").write_text("of another state of the project", encoding="utf-8")

    def interrupt(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(windows_python, "unpack", interrupt)
    with pytest.raises(KeyboardInterrupt):
        setup.set_up()
    assert not (tmp_path / "stamp").exists()
