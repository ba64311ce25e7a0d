"""From a key on the pad to the first picture in which the robot has moved, and pictures a second; prints JSON.

A real Chromium, which draws in software; robot_world with Vera and SLAM, on the desk as in chapter 0. null without Chromium.
"""

import json
import os
import statistics
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2]))

PRESSES = 9
CELLS = (
    "from coursekit.lab import *",
    "%ros2 launch coursekit_robots simulation.launch.py world:=robot_world slam:=true &",
    """wait(3, until="/map")
shown = ["Grid", "RobotModel", {"type": "LaserScan", "topic": "/scan"}, {"type": "Map", "topic": "/map"}]
view = viewer(fixed_frame="map", displays=shown)
desk(view, pad(linear=0.4))""",
)
MEASURE = """async (presses) => {
  const scene = document.querySelector('.ck-viewer').viewer, field = document.querySelector('.ck-pad .ck-field');
  const rest = (ms) => new Promise((done) => setTimeout(done, ms));
  const robot = () => {
    const at = [...scene.shadows.robots.values()][0].spot.position;
    return [at.x, at.y, at.z];
  };
  const key = (kind) => field.dispatchEvent(new KeyboardEvent(kind, { code: 'ArrowUp', key: 'ArrowUp', bubbles: true }));
  let pictures = 0;
  scene.after.push(() => { pictures += 1; });
  field.focus();
  const times = [];
  for (let press = 0; press < presses; press += 1) {
    await rest(1500);
    const before = robot(), begin = performance.now();
    const moved = new Promise((done) => {
      const look = () => {
        const now = robot();
        if (Math.hypot(...now.map((one, i) => one - before[i])) > 1e-3) done(performance.now() - begin);
      };
      scene.after.push(look);
      setTimeout(() => done(null), 3000);
    });
    key('keydown');
    times.push(await moved);
    key('keyup');
  }
  await rest(500);
  key('keydown');
  await rest(500);
  const had = pictures, since = performance.now();
  await rest(3000);
  const rate = (pictures - had) / (performance.now() - since) * 1000;
  key('keyup');
  return { times, rate };
}"""


def main() -> dict[str, float] | None:
    """Open a desk in Chromium and measure."""
    from tests.browser.conftest import chromium
    from tests.browser.pages import Notebook, close, lab_in, write_notebook

    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        return None
    if chromium() is None:
        return None
    with tempfile.TemporaryDirectory() as place, sync_playwright() as driver:
        write_notebook(Path(place, "desk.ipynb"), CELLS)
        os.environ.pop("COURSEKIT_ALONE", None)  # its kernel has a session
        with lab_in(Path(place), 46) as lab:
            browser = driver.chromium.launch(executable_path=chromium(), args=["--no-sandbox"])
            page = browser.new_page(viewport={"width": 1366, "height": 768})
            Notebook(page, lab, "desk.ipynb").run()
            page.wait_for_selector(".jupyterlab-sidecar .ck-viewer[data-messages]")
            page.wait_for_function("() => document.querySelector('.ck-viewer').viewer?.shadows.robots.size", timeout=60_000)
            page.wait_for_timeout(5000)
            told = page.evaluate(MEASURE, PRESSES)
            close(page)
            browser.close()
    times = [time for time in told["times"] if time is not None]
    return {"latency": statistics.median(times), "slowest": max(times), "missed": PRESSES - len(times), "rate": told["rate"]}


if __name__ == "__main__":
    print(json.dumps(main()))
