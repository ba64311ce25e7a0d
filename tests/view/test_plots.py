"""matplotlib in a process: figures are windows of the session, animations keep its time, Ctrl-C ends plt.show()."""

from types import SimpleNamespace

import pytest

from coursekit.processes.session import Session
from coursekit.view.highgui import desk


def animated():
    import matplotlib.pyplot as plt
    from matplotlib.animation import FuncAnimation

    figure, axes = plt.subplots(figsize=(2, 1))
    frames = []
    animation = FuncAnimation(figure, lambda n: frames.append(n) or axes.plot(frames), interval=200, cache_frame_data=False)
    try:
        plt.show()
    except KeyboardInterrupt:
        print("frames", len(frames), bool(animation))


def test_an_animation_runs_until_ctrl_c():
    with Session(virtual=True).use() as session:
        process = session.start(animated, name="animated")
        session.clock.sleep(2.05)
        (window,) = desk().windows.values()
        assert window.name.startswith("Figure ") and window.image.shape == (100, 200, 3) and window.shown > 5
        process.interrupt()
        assert process.wait(5) == 0
        assert 9 <= int(process.output.split()[1]) <= 13
        assert not desk().windows, process.output


@pytest.mark.parametrize("by", ["pause", "flush", "show"])
def test_a_loop_that_draws_is_shown_and_pause_takes_its_time(by):
    def live():
        import time

        import matplotlib.pyplot as plt

        plt.ion()
        figure, axes = plt.subplots(num="my plot", figsize=(2, 1))
        (line,) = axes.plot([0, 1])
        for height in range(3):
            line.set_ydata([0, height])
            if by == "pause":
                plt.pause(0.5)
            else:
                plt.show() if by == "show" else (figure.canvas.draw_idle(), figure.canvas.flush_events())
                time.sleep(0.5)
        print(desk().windows["my plot"].shown)
        plt.ioff()

    with Session(virtual=True).use() as session:
        process = session.start(live, name="live")
        assert process.wait(1.4) is None and process.wait(0.2) == 0
        assert int(process.output) >= 1


def test_no_toolkit_is_asked_for_a_window(monkeypatch):
    """On Windows, on macOS and on any desk there is one, and it works in the main thread only."""

    def refuse(*args, **kwargs):
        raise RuntimeError("a toolkit in a thread")

    def shown():
        import matplotlib.pyplot as plt

        plt.plot([0, 1])
        plt.show(block=False)
        print(plt.get_fignums())

    plots = pytest.importorskip("matplotlib.pyplot")
    toolkit = SimpleNamespace(new_figure_manager=refuse, draw_if_interactive=lambda: None)
    monkeypatch.setattr(plots, "_get_backend_mod", lambda: toolkit)
    with Session(virtual=True).use() as session:
        process = session.start(shown, name="shown")
        assert process.wait(1.0) == 0, process.output
        assert process.output == "[1]\n"
