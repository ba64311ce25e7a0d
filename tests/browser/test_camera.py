"""The virtual camera at 640x480 and 30 Hz in a real browser."""

import pytest

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(180)]

CAMERA = """
import rclpy, threading
from rclpy.executors import SingleThreadedExecutor
from sensor_msgs.msg import Image
from cv_bridge import CvBridge
import cv2

rclpy.init()
node = rclpy.create_node("camera")
publisher = node.create_publisher(Image, "camera/image_raw", 1)
camera, bridge = cv2.VideoCapture(0), CvBridge()
sent = []

def send():
    image = camera.read()[1]
    sent.append(1)
    cv2.putText(image, str(len(sent)), (10, 30), cv2.FONT_HERSHEY_SIMPLEX, 1, (0, 0, 0), 2)
    publisher.publish(bridge.cv2_to_imgmsg(image, "bgr8"))

node.create_timer(1 / 30, send)
executor = SingleThreadedExecutor()
executor.add_node(node)
threading.Thread(target=executor.spin, daemon=True).start()
"""
RATE = "() => document.querySelector('.ck-picture .ck-note')?.textContent ?? ''"


def test_thirty_images_a_second_are_shown_without_falling_behind(notebook, picture):
    opened = notebook("from coursekit.lab import *", CAMERA, "view = image_view('camera/image_raw')\nview")
    opened.run()
    page = opened.page
    page.wait_for_function(
        "() => /fps/.test(document.querySelector('.ck-picture .ck-note')?.textContent)", timeout=30_000
    )
    fast = "() => { const note = (%s)(); return /^640x480 bgr8 · ([2-9][0-9]) fps/.test(note); }"
    page.wait_for_function(fast % RATE, timeout=60_000)
    picture(page.locator(".ck-picture"), "camera")
    opened.eventually("print(view.count - view.drawn <= 3)", "True")  # the newest image is drawn, none waits


def test_a_window_of_imshow_takes_keys(notebook, picture):
    opened = notebook(
        "from coursekit.lab import *\nimport cv2",
        "_, image = cv2.VideoCapture(0).read()\ncv2.imshow('frame', image)",
        "import threading\nkeys = []\n"
        "threading.Thread(target=lambda: [keys.append(cv2.waitKey(0)) for _ in range(2)], daemon=True).start()",
    )
    opened.run()
    page = opened.page
    page.locator(".ck-picture img[src]").wait_for(timeout=30_000)
    page.locator(".ck-picture .ck-screen").click()
    page.keyboard.press("q")
    page.keyboard.press("Escape")
    opened.eventually("print(keys)", f"[{ord('q')}, 27]")
    picture(page.locator(".ck-picture"), "imshow")


def test_a_window_has_trackbars_and_tells_of_clicks(notebook, picture):
    opened = notebook(
        "from coursekit.lab import *\nimport cv2\nimport threading\ntold = []",
        "_, image = cv2.VideoCapture(0).read()\ncv2.namedWindow('tune')\n"
        "cv2.createTrackbar('hue', 'tune', 20, 179, lambda value: told.append(value))\n"
        "cv2.setMouseCallback('tune', lambda *given: told.append(given) if given[0] else None)\n"
        "cv2.imshow('tune', image)\nthreading.Thread(target=lambda: cv2.waitKey(0), daemon=True).start()",
    )
    opened.run()
    page = opened.page
    image = page.locator(".ck-picture img[src]")
    image.wait_for(timeout=30_000)
    slider = page.get_by_label("hue")
    slider.focus()
    page.keyboard.press("End")
    page.keyboard.press("ArrowLeft")
    opened.eventually("print(told)", "[179, 178]")
    box = image.bounding_box()
    image.click(position={"x": box["width"] / 2, "y": box["height"] / 2})
    opened.eventually("print([event for event, *_ in told[2:]])", "[1, 4]")  # pressed and released
    opened.eventually("print(all(abs(x - 320) < 3 and abs(y - 240) < 3 for _, x, y, *_ in told[2:]))", "True")
    picture(page.locator(".ck-picture"), "trackbars")
