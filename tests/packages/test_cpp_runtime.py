"""The runtime of C++ programs is built once, whoever asks for it meanwhile."""

from __future__ import annotations

import threading

from coursekit.cpp import runtime


def test_who_asks_while_it_is_built_waits_for_it(tmp_path, monkeypatch):
    built, second_asks = [], threading.Event()

    def build(folder, *_):
        assert second_asks.wait(10.0)
        built.append(folder)

    for name in ("write_headers", "_write_configs", "write_forwarded"):
        monkeypatch.setattr(runtime, name, lambda folder, *_: folder.mkdir(parents=True, exist_ok=True))
    monkeypatch.setattr(runtime, "_build_library", build)
    folder = tmp_path / "cpp" / "key"
    first = threading.Thread(target=runtime.make_runtime, args=(folder, None))
    first.start()
    second_asks.set()
    runtime.make_runtime(folder, None)
    first.join()
    assert folder.is_dir() and len(built) == 1
    assert [path.name for path in folder.parent.iterdir() if path.name.startswith(".making")] == []
