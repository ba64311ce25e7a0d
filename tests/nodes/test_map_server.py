"""The map server, the map saver and the lifecycle manager, on the virtual clock."""

import numpy as np
import pytest
import rclpy
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState
from nav2_msgs.srv import LoadMap, ManageLifecycleNodes, SaveMap
from nav_msgs.msg import OccupancyGrid
from nav_msgs.srv import GetMap
from std_srvs.srv import Trigger

from coursekit.nav.map_file import GridMap, load_map, save_map
from coursekit.nodes.nav2.map_message import MAP_QOS, from_message
from tests.needs import slashed
from tests.nodes.friend import Friend

CELLS = np.array([[0, 100, -1], [-1, 0, 0]], dtype=np.int8)


class Reader(Friend):
    """Hears maps and asks services."""

    def __init__(self, session):
        super().__init__(session)
        self.maps = []

    def listen(self, topic="map"):
        self.node.create_subscription(OccupancyGrid, topic, self.maps.append, MAP_QOS)
        self.spin(0.2)

    def manage(self, command):
        return self.ask(ManageLifecycleNodes, "lifecycle_manager/manage_nodes", command=command).success

    @property
    def active(self):
        return self.ask(Trigger, "lifecycle_manager/is_active").success


@pytest.fixture
def friend(session):
    new_friend = Reader(session)
    yield new_friend
    rclpy.shutdown(context=new_friend.context)


@pytest.fixture
def house(tmp_path):
    return save_map(tmp_path / "house", GridMap(CELLS, 0.05, (-1.0, 2.0, 0.5)))[0]


@pytest.fixture
def serve(run, session):
    def start(file, *more, autostart="true"):
        server = run("nav2_map_server", "map_server", "--ros-args", "-p", f"yaml_filename:={file}", *more)
        names = ("-p", "node_names:=[map_server]", "-p", f"autostart:={autostart}")
        manager = run("nav2_lifecycle_manager", "lifecycle_manager", "--ros-args", *names)
        session.clock.sleep(1.0)
        return server, manager

    return start


def test_the_manager_activates_the_server_and_a_late_subscriber_gets_the_map(serve, friend, session, house):
    server, manager = serve(house)
    assert "Managed nodes are active" in manager.output and friend.active
    session.clock.sleep(5.0)
    friend.listen()
    (msg,) = friend.maps
    grid = from_message(msg)
    assert grid.cells.tolist() == CELLS.tolist()
    assert (grid.resolution, grid.origin) == (0.05, pytest.approx((-1.0, 2.0, 0.5)))
    assert msg.header.frame_id == "map"
    for process in (manager, server):
        process.interrupt()
        assert process.wait(2.0) == 0


def test_topic_and_frame_are_parameters(serve, friend, house):
    serve(house, "-p", "topic_name:=plan", "-p", "frame_id:=world")
    friend.listen("plan")
    assert [msg.header.frame_id for msg in friend.maps] == ["world"]


def test_nothing_is_served_before_the_server_is_active(serve, friend, house):
    serve(house, autostart="false")
    friend.listen()
    assert friend.maps == [] and not friend.active
    assert friend.manage(0) and friend.active
    friend.spin(0.2)
    assert len(friend.maps) == 1


def test_the_manager_pauses_resumes_resets_and_shuts_down(serve, friend, house, ros2):
    serve(house)
    for command, state in ((1, "inactive [2]"), (2, "active [3]"), (3, "unconfigured [1]"), (0, "active [3]")):
        assert friend.manage(command)
        assert ros2("lifecycle", "get", "/map_server").strip() == state
    assert friend.manage(4) and not friend.active
    assert ros2("lifecycle", "get", "/map_server").strip() == "finalized [4]"
    assert not friend.manage(9)


def test_a_server_without_its_map_is_told_and_bringup_ends(serve, friend, tmp_path):
    server, manager = serve(tmp_path / "none.yaml")
    assert "none.yaml: cannot be read: No such file or directory" in server.output
    assert "Failed to change state for node: map_server" in manager.output
    assert not friend.active


def test_get_map_answers_the_map(serve, friend, house):
    serve(house)
    assert from_message(friend.ask(GetMap, "map_server/map").map).cells.tolist() == CELLS.tolist()


def test_load_map_answers_with_the_code_of_the_fault_and_keeps_the_map(serve, friend, house, tmp_path):
    serve(house)
    friend.listen()
    (tmp_path / "bare.yaml").write_text(house.read_text().replace("house.pgm", "none.pgm"))
    files = {"": 1, str(tmp_path / "bare.yaml"): 2, str(tmp_path / "none.yaml"): 3}
    for file, code in files.items():
        assert friend.ask(LoadMap, "map_server/load_map", map_url=file).result == code
    assert len(friend.maps) == 1
    save_map(tmp_path / "flat", GridMap(np.zeros((1, 2), dtype=np.int8), 0.1))
    answer = friend.ask(LoadMap, "map_server/load_map", map_url=str(tmp_path / "flat.yaml"))
    friend.spin(0.2)
    assert answer.result == 0 and list(answer.map.data) == [0, 0]
    assert [list(msg.data) for msg in friend.maps[1:]] == [[0, 0]]


@pytest.mark.parametrize(
    ("arguments", "ending"),
    [
        (("--free", "0.196"), "pgm"),
        (("--fmt", "bmp", "--free", "0.196"), "bmp"),
        (("--mode", "scale", "--occ", "0.99", "--free", "0.01"), "png"),
    ],
)
def test_the_saver_writes_what_the_server_serves_and_says_where(serve, run, house, tmp_path, arguments, ending):
    serve(house)
    saver = run("nav2_map_server", "map_saver_cli", "-f", str(tmp_path / "copy"), *arguments)
    assert saver.wait(5.0) == 0
    place = slashed(tmp_path)
    for line in (f"data to {place}/copy.{ending}", f"metadata to {place}/copy.yaml", "Map saved successfully"):
        assert line in slashed(saver.output)
    grid = load_map(tmp_path / "copy.yaml")
    assert grid.cells.tolist() == CELLS.tolist()
    assert (grid.resolution, grid.origin) == (0.05, (-1.0, 2.0, 0.5))


def test_the_saver_s_own_threshold_is_humble_s_and_makes_the_unknown_free(serve, run, house, tmp_path):
    serve(house)
    saver = run("nav2_map_server", "map_saver_cli", "-f", str(tmp_path / "copy"))
    assert saver.wait(5.0) == 0
    assert "Free threshold unspecified. Setting it to default value: 0.250000" in saver.output
    assert "free_thresh: 0.25\n" in (tmp_path / "copy.yaml").read_text()
    assert load_map(tmp_path / "copy.yaml").cells.tolist() == np.where(CELLS == -1, 0, CELLS).tolist()


def test_the_saver_without_a_map_says_so_and_ends(run, session, tmp_path):
    timeout = ("--ros-args", "-p", "save_map_timeout:=7.0")
    saver = run("nav2_map_server", "map_saver_cli", "-t", "plan", "-f", str(tmp_path / "copy"), *timeout)
    assert saver.wait(6.9) is None
    assert saver.wait(1.0) == 1
    assert "Failed to spin map subscription" in saver.output
    assert "No map came on 'plan' in 7 s" in saver.output
    assert list(tmp_path.iterdir()) == []


def test_the_saver_tells_when_it_cannot_write(serve, run, house, tmp_path):
    serve(house)
    saver = run("nav2_map_server", "map_saver_cli", "-f", str(tmp_path / "no" / "copy"))
    assert saver.wait(5.0) == 1
    assert "Failed to write map for reason" in saver.output and str(tmp_path / "no") in saver.output


def test_the_saver_server_saves_on_request(serve, run, friend, house, tmp_path):
    serve(house)
    run("nav2_map_server", "map_saver_server")
    for transition in (Transition.TRANSITION_CONFIGURE, Transition.TRANSITION_ACTIVATE):
        friend.ask(ChangeState, "map_saver/change_state", transition=Transition(id=transition))
    target = str(tmp_path / "copy")
    request = {"map_url": target, "free_thresh": 0.196, "occupied_thresh": 0.65}
    assert friend.ask(SaveMap, "map_saver/save_map", map_topic="map", **request).result
    assert load_map(target + ".yaml").cells.tolist() == CELLS.tolist()
    assert "free_thresh: 0.196\n" in (tmp_path / "copy.yaml").read_text()
    assert not friend.ask(SaveMap, "map_saver/save_map", map_topic="nowhere", **request).result
