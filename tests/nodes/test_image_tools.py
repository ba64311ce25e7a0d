"""image_tools: the burger flies, flips and is seen."""

import numpy
import pytest
from cv_bridge import CvBridge
from sensor_msgs.msg import Image

from coursekit.nodes.image_tools.burger import Burgers
from coursekit.view.highgui import desk


def test_burgers_move_and_stay_in_the_picture():
    burgers = Burgers(160, 120)
    sky = (burgers.draw() != (230, 190, 130)).any(axis=2)
    least = sky.sum()
    assert least > 0
    pictures = [(burgers.draw() != (230, 190, 130)).any(axis=2) for _ in range(200)]
    assert not numpy.array_equal(pictures[0], sky)
    assert all(picture.sum() >= 24 * 24 for picture in pictures)  # one at least is whole


def test_the_camera_program_shows_what_it_publishes_where_it_is_asked_to(session, run):
    cam = run("image_tools", "cam2image", "--ros-args", "-p", "burger_mode:=true", "-p", "show_camera:=true")
    session.clock.sleep(0.5)
    assert desk().windows["cam2image"].image.shape == (240, 320, 3)
    cam.interrupt()
    assert cam.wait(5) == 0 and "cam2image" not in desk().windows


def test_the_burger_is_published_and_seen(session, run, ros2):
    cam = run("image_tools", "cam2image", "--ros-args", "-p", "burger_mode:=true", "-p", "width:=64", "-p", "height:=48")
    show = run("image_tools", "showimage")
    session.clock.sleep(1.02)
    assert "Publishing image #30" in cam.output
    assert show.output.count("Received image #camera_frame") >= 29
    seen = ros2("topic", "echo", "--once", "--no-arr", "/image")
    assert "height: 48\nwidth: 64\nencoding: bgr8\n" in seen
    assert ros2("topic", "pub", "--once", "/flip_image", "std_msgs/msg/Bool", "data: true")
    assert "Set flip mode to: on" in cam.output


def test_best_effort_images_do_not_reach_a_reliable_viewer(session, run):
    run("image_tools", "cam2image", "--ros-args", "-p", "burger_mode:=true", "-p", "reliability:=best_effort")
    show = run("image_tools", "showimage")
    easy = run("image_tools", "showimage", "--ros-args", "-r", "__node:=easy", "-p", "reliability:=best_effort")
    session.clock.sleep(0.5)
    assert "Received image" not in show.output and "Received image" in easy.output


def test_without_a_camera_it_says_what_to_type(run):
    cam = run("image_tools", "cam2image", "--ros-args", "-p", "device_id:=97")
    assert cam.wait(10) != 0
    assert "burger_mode:=true" in cam.output and "Could not open video stream" in cam.output


def test_a_wrong_word_is_refused(run):
    show = run("image_tools", "showimage", "--ros-args", "-p", "reliability:=maybe")
    assert show.wait(10) != 0
    assert "Invalid reliability 'maybe'; there are: reliable, best_effort" in show.output


def test_an_image_has_three_bytes_a_pixel():
    msg: Image = CvBridge().cv2_to_imgmsg(Burgers(20, 10).draw(), "bgr8")
    assert (msg.step, len(msg.data)) == (60, 600)


@pytest.mark.parametrize("program", ["cam2image", "showimage"])
@pytest.mark.parametrize("word", ["-h", "--help"])
def test_help_names_every_parameter_and_makes_no_node(run, ros2, session, program, word):
    asked = run("image_tools", program, word)
    assert asked.wait(2.0) == 0 and asked.output.startswith(f"Usage: {program} [-h] [--ros-args [-p param:=value] ...]\n")
    assert not session.graph(0).nodes
    told = {line.split()[0] for line in asked.output.partition("Parameters:\n")[2].splitlines()}
    run("image_tools", program, *(["--ros-args", "-p", "burger_mode:=true"] if program == "cam2image" else []))
    session.clock.sleep(0.5)
    declared = set(ros2("param", "list", f"/{program}").split())
    assert told == {name for name in declared if name != "use_sim_time" and not name.startswith("qos_overrides")}
