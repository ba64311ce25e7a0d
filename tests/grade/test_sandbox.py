"""What a sandboxed program sees."""

import sys

import pytest

from coursekit.grade import sandbox


@pytest.mark.skipif(sandbox.tier() != "bubblewrap", reason="no bubblewrap: apt-get install bubblewrap")
def test_an_installation_below_tmp_is_seen(tmp_path_factory, monkeypatch):
    """A checkout, with its interpreter, may lie in the system's folder for temporary files."""
    installed, work = tmp_path_factory.mktemp("installed"), tmp_path_factory.mktemp("work")
    (installed / "here.txt").write_text("seen")
    own = sandbox._python_folders()
    monkeypatch.setattr(sandbox, "_python_folders", lambda: [*own, str(installed)])
    command = [sys.executable, "-c", f"print(open({str(installed / 'here.txt')!r}).read())"]
    running = sandbox.start(command, work, {}, sandbox.Limits())
    out, _ = running.child.communicate(timeout=60)
    running.end()
    assert out == b"seen\n"
