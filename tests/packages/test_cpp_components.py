"""Containers of a student's own: programs that make a ComponentManager, which loads components while it runs."""

from __future__ import annotations

import pytest

from tests.packages.pip_tools import loading_tools_or_skip
from tests.packages.test_cpp_workspace import colcon, scripted

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]
MANIFEST = """<?xml version="1.0"?>
<package format="3"><name>{name}</name><version>0.1.0</version><description>Parts.</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license><buildtool_depend>ament_cmake</buildtool_depend>
<depend>rclcpp</depend><depend>rclcpp_components</depend><depend>std_msgs</depend>
<export><build_type>ament_cmake</build_type></export></package>
"""
CMAKE = """
cmake_minimum_required(VERSION 3.8)
project({name})
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
find_package(rclcpp_components REQUIRED)
find_package(std_msgs REQUIRED)
{targets}
ament_package()
"""
CONTAINERS = """
add_executable(plain src/plain.cpp)
ament_target_dependencies(plain rclcpp rclcpp_components)
add_executable(isolated src/isolated.cpp)
target_link_libraries(isolated rclcpp_components::component_manager rclcpp::rclcpp)
install(TARGETS plain isolated DESTINATION lib/${PROJECT_NAME})
"""
PARTS = """
add_library(parts SHARED src/parts.cpp)
ament_target_dependencies(parts rclcpp rclcpp_components std_msgs)
set_target_properties(parts PROPERTIES OUTPUT_NAME parts_of_k)
rclcpp_components_register_nodes(parts "k_parts::Source" "k_parts::Sink" "k_parts::Broken")
install(TARGETS parts ARCHIVE DESTINATION lib LIBRARY DESTINATION lib RUNTIME DESTINATION bin)
"""
PLAIN = """
#include "rclcpp_components/component_manager.hpp"
class Counting : public rclcpp_components::ComponentManager
{
public:
  using ComponentManager::ComponentManager;

protected:
  void add_node_to_executor(uint64_t node_id) override
  {
    RCLCPP_INFO(get_logger(), "number %d", static_cast<int>(node_id));
    ComponentManager::add_node_to_executor(node_id);
  }
};
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto executor = std::make_shared<rclcpp::executors::SingleThreadedExecutor>();
  auto manager = std::make_shared<Counting>(executor);
  executor->add_node(manager);
  executor->spin();
}
"""
ISOLATED = """
#include "rclcpp_components/component_manager_isolated.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto executor = std::make_shared<rclcpp::executors::MultiThreadedExecutor>();
  auto manager = std::make_shared<rclcpp_components::ComponentManagerIsolated<>>(executor);
  executor->add_node(manager);
  executor->spin();
}
"""
PARTS_CPP = """
#include "rclcpp_components/register_node_macro.hpp"
#include "std_msgs/msg/int32.hpp"
using std_msgs::msg::Int32;
namespace k_parts
{
const Int32 * g_sent = nullptr;
class Source : public rclcpp::Node
{
public:
  explicit Source(const rclcpp::NodeOptions & options)
  : Node("source", options)
  {
    publisher_ = create_publisher<Int32>("number", 10);
    timer_ = create_wall_timer(std::chrono::milliseconds(100), [this, step = declare_parameter("step", 1)] {
          auto message = std::make_unique<Int32>();
          message->data = sent_ += static_cast<int>(step);
          g_sent = message.get();
          publisher_->publish(std::move(message));
        });
  }

private:
  int sent_ = 0;
  rclcpp::Publisher<Int32>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
};
class Sink : public rclcpp::Node
{
public:
  explicit Sink(const rclcpp::NodeOptions & options)
  : Node("sink", options)
  {
    subscription_ = create_subscription<Int32>("number", 10, [this](Int32::UniquePtr message) {
          RCLCPP_INFO(get_logger(), "%d %s", message->data, message.get() == g_sent ? "itself" : "copied");
        });
  }

private:
  rclcpp::Subscription<Int32>::SharedPtr subscription_;
};
struct Broken : rclcpp::Node
{
  explicit Broken(const rclcpp::NodeOptions & options)
  : Node("broken", options) {throw std::runtime_error("no spring");}
};
}
RCLCPP_COMPONENTS_REGISTER_NODE(k_parts::Source)
RCLCPP_COMPONENTS_REGISTER_NODE(k_parts::Sink)
RCLCPP_COMPONENTS_REGISTER_NODE(k_parts::Broken)
"""
FILES = {
    "k_boxes/package.xml": MANIFEST.format(name="k_boxes"),
    "k_boxes/CMakeLists.txt": CMAKE.format(name="k_boxes", targets=CONTAINERS),
    "k_boxes/src/plain.cpp": PLAIN,
    "k_boxes/src/isolated.cpp": ISOLATED,
    "k_parts/package.xml": MANIFEST.format(name="k_parts"),
    "k_parts/CMakeLists.txt": CMAKE.format(name="k_parts", targets=PARTS),
    "k_parts/src/parts.cpp": PARTS_CPP,
}
SCRIPT = """
from composition_interfaces.srv import ListNodes, LoadNode, UnloadNode
from coursekit.processes.executables import find, make_process
from coursekit.processes.session import Session
from rcl_interfaces.msg import Parameter, ParameterValue
import rclpy

NEAR = Parameter(name="use_intra_process_comms", value=ParameterValue(type=1, bool_value=True))
with (session := Session(virtual=True)).use():
    box = session.launch(make_process(session, find("k_boxes", "{program}"), name="box"))
    rclpy.init()
    node = rclpy.create_node("asker")

    def call(kind, name, **fields):
        client = node.create_client(kind, "/ComponentManager/_container/" + name)
        client.wait_for_service(5.0)
        future = client.call_async(kind.Request(**fields))
        rclpy.spin_until_future_complete(node, future, timeout_sec=15)
        return future.result()

    def load(plugin, package="k_parts", **fields):
        answer = call(LoadNode, "load_node", package_name=package, plugin_name=plugin, **fields)
        print("load", answer.unique_id, answer.full_node_name or answer.error_message)

    {body}
    print("nodes", *sorted(space.rstrip("/") + "/" + name for name, space in node.get_node_names_and_namespaces()))
    box.interrupt()
    print("ended", box.wait(10.0))
print(box.output)
"""
IN_ONE = """
    step = Parameter(name="step", value=ParameterValue(type=2, integer_value=5))
    load("k_parts::Source", parameters=[step], extra_arguments=[NEAR])
    load("k_parts::Sink", node_name="drain", node_namespace="/deep", remap_rules=["number:=/number"], extra_arguments=[NEAR])
    print("list", *call(ListNodes, "list_nodes").full_node_names)
    rclpy.spin_once(node, timeout_sec=0.25)
    print("unload", call(UnloadNode, "unload_node", unique_id=1).success)
"""
FAULTS = """
    load("k_parts::Broken")
    load("k_parts::Nothing")
    load("k_parts::Source", package="k_nowhere")
    wrong = Parameter(name="use_intra_process_comms", value=ParameterValue(type=2, integer_value=1))
    load("k_parts::Sink", extra_arguments=[wrong])
    print("unload", call(UnloadNode, "unload_node", unique_id=77).error_message)
"""
APART = """
    load("demo_nodes_cpp::Talker", package="demo_nodes_cpp", node_name="far", remap_rules=["chatter:=chat"])
    rclpy.spin_once(node, timeout_sec=1.2)
    print("topic", node.count_publishers("/chat"))
    print("unload", call(UnloadNode, "unload_node", unique_id=1).success)
"""
MADE = "[INFO] [1700000000.000000000] [ComponentManager]: {} class: rclcpp_components::NodeFactoryTemplate<{}>"


@pytest.fixture(scope="module", params=["own tools", "pip's tools"])
def workspace(request, tmp_path_factory):
    env = loading_tools_or_skip(request.param, tmp_path_factory.mktemp("bin"))
    folder = tmp_path_factory.mktemp("components_ws")
    for name, text in FILES.items():
        path = folder / "src" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text.lstrip(), encoding="utf-8")
    built = colcon(folder, "build", env=env)
    assert built.returncode == 0 and "2 packages finished" in built.stdout, built.stdout + built.stderr
    return folder


def said(workspace, program, body):
    done = scripted(workspace, SCRIPT.format(program=program, body=body.strip()))
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout.splitlines()


@pytest.mark.parametrize("program", ["plain", "isolated"])
def test_components_are_loaded_into_the_program_and_share_what_they_send(workspace, program):
    lines = said(workspace, program, IN_ONE)
    assert lines[:5] == [
        "load 1 /source",
        "load 2 /deep/drain",
        "list /source /deep/drain",
        "unload True",
        "nodes /ComponentManager /asker /deep/drain",
    ]
    assert lines[5] == "ended 0"
    assert [line for line in lines if "deep.drain" in line] == [
        "[INFO] [1700000000.100000000] [deep.drain]: 5 itself",
        "[INFO] [1700000000.200000000] [deep.drain]: 10 itself",
    ]
    for what in ("Found", "Instantiate"):
        assert MADE.format(what, "k_parts::Sink") in lines
    overridden = [line for line in lines if "number" in line]
    assert len(overridden) == (2 if program == "plain" else 0)


def test_what_cannot_be_loaded_is_told_in_humbles_words(workspace):
    assert said(workspace, "plain", FAULTS)[:7] == [
        "load 0 Component constructor threw an exception: no spring",
        "load 0 Failed to find class with the requested plugin name.",
        "load 0 Could not find requested resource in ament index",
        "load 0 Extra component argument 'use_intra_process_comms' must be a boolean",
        "unload No node found with unique_id: 77",
        "nodes /ComponentManager /asker",
        "ended 0",
    ]


def test_a_component_that_is_no_library_runs_as_a_program_of_its_own(workspace):
    lines = said(workspace, "plain", APART)
    assert lines[:5] == ["load 1 /far", "topic 1", "unload True", "nodes /ComponentManager /asker", "ended 0"]
    assert "[INFO] [1700000001.000000000] [far]: Publishing: 'Hello World: 1'" in lines
