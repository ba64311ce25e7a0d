"""Classes that a C++ program loads while it runs: plugins by their descriptions, components from their libraries."""

from __future__ import annotations

import pytest

from coursekit.cpp.age import MARK
from tests.packages.pip_tools import loading_tools_or_skip
from tests.packages.test_cpp_workspace import colcon, scripted, sourced

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]
MANIFEST = """<?xml version="1.0"?>
<package format="3"><name>{name}</name><version>0.1.0</version><description>Tools.</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license><buildtool_depend>ament_cmake_ros</buildtool_depend>
{depends}<export><build_type>ament_cmake</build_type></export></package>
"""
BASE = """
#pragma once
namespace shop
{
class Tool
{
public:
  virtual ~Tool() = default;
  virtual void set(double arm) = 0;
  virtual double force() const = 0;
};
}
"""
BASE_CMAKE = """
cmake_minimum_required(VERSION 3.8)
project(k_tool)
find_package(ament_cmake REQUIRED)
find_package(pluginlib REQUIRED)
add_executable(user src/user.cpp)
target_include_directories(user PUBLIC include)
ament_target_dependencies(user pluginlib)
add_executable(loader src/loader.cpp)
find_package(rclcpp_components REQUIRED)
ament_target_dependencies(loader rclcpp_components)
install(TARGETS user loader DESTINATION lib/${PROJECT_NAME})
install(DIRECTORY include/ DESTINATION include)
ament_export_include_directories(include)
ament_package()
"""
USER = """
#include <iostream>
#include <pluginlib/class_loader.hpp>
#include "k_tool/tool.hpp"
int main()
{
  pluginlib::ClassLoader<shop::Tool> loader("k_tool", "shop::Tool");
  for (auto & name : loader.getDeclaredClasses()) {
    std::cout << name << " is " << loader.getClassType(name) << ": " << loader.getClassDescription(name) << std::endl;
  }
  {
    std::shared_ptr<shop::Tool> hammer = loader.createSharedInstance("k_tools::Hammer");
    auto press = loader.createUniqueInstance("a_press");
    hammer->set(2.0);
    press->set(3.0);
    std::cout << hammer->force() << " " << press->force() << " " << loader.isClassLoaded("a_press") << std::endl;
  }
  for (auto & path : loader.getPluginXmlPaths()) {
    std::cout << path.substr(path.rfind("/k_tools/")) << std::endl;
  }
  try {
    loader.createSharedInstance("k_tools::Saw");
  } catch (const pluginlib::PluginlibException & error) {
    std::cout << error.what() << std::endl;
  }
  try {
    loader.createSharedInstance("lost");
  } catch (const pluginlib::LibraryLoadException & error) {
    std::cout << error.what() << std::endl;
  }
  for (auto & path : loader.getPluginXmlPaths()) {
    std::cout << pluginlib::ClassLoader<shop::Tool>("k_tool", "shop::Tool", "", {path}).getDeclaredClasses().size();
  }
  std::cout << pluginlib::ClassLoader<shop::Tool>("k_tool", "shop::Tool", "other").getDeclaredClasses().size() << std::endl;
  try {
    pluginlib::ClassLoader<shop::Tool>("k_tool", "shop::Tool", "broken");
  } catch (const pluginlib::InvalidXMLException & error) {
    std::cout << "broken" << std::endl;
  }
  try {
    pluginlib::ClassLoader<shop::Tool>("k_nowhere", "shop::Tool");
  } catch (const pluginlib::ClassLoaderException &) {
    std::cout << "no such package" << std::endl;
  }
}
"""
LOADER = """
#include "class_loader/multi_library_class_loader.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/node_factory.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::executors::SingleThreadedExecutor executor;
  std::vector<rclcpp_components::NodeInstanceWrapper> nodes;
  class_loader::MultiLibraryClassLoader all(false);
  for (int i = 1; i < argc; ++i) {
    all.loadLibrary(argv[i]);
    for (auto & name : all.getAvailableClassesForLibrary<rclcpp_components::NodeFactory>(argv[i])) {
      std::cout << "makes " << name << std::endl;
      auto factory = all.createInstance<rclcpp_components::NodeFactory>(name, argv[i]);
      nodes.push_back(factory->create_node_instance(rclcpp::NodeOptions()));
      executor.add_node(nodes.back().get_node_base_interface());
    }
  }
  executor.spin();
  try {
    class_loader::MultiLibraryClassLoader(true).createUniqueInstance<rclcpp_components::NodeFactory>("Any", "k_missing");
  } catch (const class_loader::NoClassLoaderExistsException & error) {
    std::cout << std::string(error.what()).substr(0, 82) << std::endl;
  }
  try {
    class_loader::ClassLoader other(class_loader::systemLibraryFormat("k_missing"));
  } catch (const class_loader::LibraryLoadException & error) {
    std::cout << std::string(error.what()).substr(0, 39) << std::endl;
  }
}
"""
TOOLS_CMAKE = """
cmake_minimum_required(VERSION 3.8)
project(k_tools)
find_package(ament_cmake REQUIRED)
find_package(ament_cmake_ros REQUIRED)
find_package(k_tool REQUIRED)
find_package(pluginlib REQUIRED)
find_package(rclcpp REQUIRED)
find_package(rclcpp_components REQUIRED)
pluginlib_export_plugin_description_file(k_tool plugins.xml)
pluginlib_export_plugin_description_file(k_tool more/lost.xml)
ament_index_register_resource(k_tool__pluginlib__broken CONTENT "share/k_tools/package.xml\nshare/k_tools/broken.xml\n")
install(FILES broken.xml DESTINATION share/${PROJECT_NAME})
add_library(k_tools src/tools.cpp)
target_include_directories(k_tools PUBLIC
  $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
set_target_properties(k_tools PROPERTIES OUTPUT_NAME tools_of_k)
ament_target_dependencies(k_tools k_tool pluginlib)
target_compile_definitions(k_tools PRIVATE "K_TOOLS_BUILDING_LIBRARY")
add_library(lathe SHARED src/lathe.cpp)
ament_target_dependencies(lathe rclcpp rclcpp_components)
rclcpp_components_register_nodes(lathe "shop::Lathe")
install(TARGETS k_tools EXPORT export_k_tools ARCHIVE DESTINATION lib LIBRARY DESTINATION lib RUNTIME DESTINATION bin)
install(TARGETS lathe ARCHIVE DESTINATION lib LIBRARY DESTINATION lib RUNTIME DESTINATION bin)
ament_export_libraries(k_tools)
ament_export_targets(export_k_tools)
ament_package()
"""
TOOLS = """
#include <pluginlib/class_list_macros.hpp>
#include "k_tool/tool.hpp"
namespace k_tools
{
class Hammer : public shop::Tool
{
public:
  void set(double arm) override {arm_ = arm;}
  double force() const override {return 10 * arm_;}

protected:
  double arm_ = 0;
};
class Press : public Hammer
{
public:
  double force() const override {return 100 * arm_;}
};
}
PLUGINLIB_EXPORT_CLASS(k_tools::Hammer, shop::Tool)
PLUGINLIB_EXPORT_CLASS(k_tools::Press, shop::Tool)
"""
PLUGINS = """<library path="tools_of_k">
  <class type="k_tools::Hammer" base_class_type="shop::Tool"><description>It hits.</description></class>
  <class name="a_press" type="k_tools::Press" base_class_type="shop::Tool"><description>It presses.</description></class>
  <class type="k_tools::Other" base_class_type="shop::Other"><description>Another kind.</description></class>
</library>
"""
LATHE = """
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
namespace shop
{
class Lathe : public rclcpp::Node
{
public:
  explicit Lathe(const rclcpp::NodeOptions & options)
  : Node("lathe", options)
  {
    try {
      declare_parameter("speed", 1);
      declare_parameter("speed", 2);
    } catch (const rclcpp::exceptions::ParameterAlreadyDeclaredException &) {
      RCLCPP_INFO(get_logger(), "twice");
    }
    timer_ = create_wall_timer(std::chrono::milliseconds(100), [this] {
          RCLCPP_INFO(get_logger(), "turns");
          rclcpp::shutdown();
        });
  }

private:
  rclcpp::TimerBase::SharedPtr timer_;
};
}
RCLCPP_COMPONENTS_REGISTER_NODE(shop::Lathe)
"""
LOST = """<class_libraries><library path="k_lost">
  <class name="lost" type="k_tools::Lost" base_class_type="shop::Tool"><description>Nowhere.</description></class>
</library></class_libraries>
"""
FILES = {
    "k_tool/CMakeLists.txt": BASE_CMAKE,
    "k_tool/include/k_tool/tool.hpp": BASE,
    "k_tool/src/user.cpp": USER,
    "k_tool/src/loader.cpp": LOADER,
    "k_tools/CMakeLists.txt": TOOLS_CMAKE,
    "k_tools/plugins.xml": PLUGINS,
    "k_tools/more/lost.xml": LOST,
    "k_tools/broken.xml": "<library path='tools_of_k'>",
    "k_tools/src/tools.cpp": TOOLS,
    "k_tools/src/lathe.cpp": LATHE,
    "k_tool/package.xml": MANIFEST.format(
        name="k_tool", depends="<depend>pluginlib</depend><depend>class_loader</depend><depend>rclcpp_components</depend>"
    ),
    "k_tools/package.xml": MANIFEST.format(
        name="k_tools",
        depends="<depend>k_tool</depend><depend>pluginlib</depend><depend>rclcpp</depend><depend>rclcpp_components</depend>",
    ),
}


@pytest.fixture(scope="module", params=["copied", "linked", "pip's tools"])
def workspace(request, tmp_path_factory):
    env = loading_tools_or_skip(request.param, tmp_path_factory.mktemp("bin"))
    folder = tmp_path_factory.mktemp("plugins_ws")
    for name, text in FILES.items():
        path = folder / "src" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text.lstrip(), encoding="utf-8")
    options = ["--symlink-install"] if request.param == "linked" else []
    built = colcon(folder, "build", *options, env=env)
    assert built.returncode == 0 and "2 packages finished" in built.stdout, built.stdout + built.stderr
    assert "stderr" not in built.stdout + built.stderr
    return folder


def test_plugins_are_found_by_their_descriptions_and_made(workspace):
    said = sourced(workspace, "ros2 run k_tool user").stdout.splitlines()
    assert said == [
        "a_press is k_tools::Press: It presses.",
        "k_tools::Hammer is k_tools::Hammer: It hits.",
        "lost is k_tools::Lost: Nowhere.",
        "20 300 1",
        "/k_tools/more/lost.xml",
        "/k_tools/plugins.xml",
        "According to the loaded plugin descriptions the class k_tools::Saw with base class type shop::Tool does not exist. "
        "Declared types are  a_press k_tools::Hammer lost",
        "Could not find library corresponding to plugin lost. Make sure that the library 'k_lost' actually exists.",
        "120",
        "broken",
        "no such package",
    ]


RUN = """
from coursekit.processes.executables import find, make_process
from coursekit.processes.session import Session

with (session := Session(virtual=True)).use():
    process = session.launch(make_process(session, find("k_tool", "loader"), {words}, name="loader"))
    print(process.wait(20.0), process.output, end="")
"""


@pytest.mark.parametrize("by_name", [True, False])
def test_a_component_is_loaded_from_its_library(workspace, by_name):
    path = "liblathe.so" if by_name else str(workspace / "install/k_tools/lib/liblathe.so")
    said = scripted(workspace, RUN.format(words=[path]))
    assert said.stdout.splitlines() == [
        "0 makes rclcpp_components::NodeFactoryTemplate<shop::Lathe>",
        "[INFO] [1700000000.000000000] [lathe]: twice",
        "[INFO] [1700000000.100000000] [lathe]: turns",
        "There is no ClassLoader in MultiLibraryClassLoader bound to library k_missing Ensu",
        "Could not load library libk_missing.so:",
    ], said.stderr


def test_a_library_of_another_version_is_not_loaded(workspace, tmp_path):
    data, old = (workspace / "install/k_tools/lib/liblathe.so").read_bytes(), tmp_path / "liblathe.so"
    at = data.index(MARK) + len(MARK)
    old.write_bytes(data[:at] + b"0" * 16 + data[at + 16 :])
    said = scripted(workspace, RUN.format(words=[str(old)])).stdout
    assert f"Could not load library {old}: it was built by another version of coursekit than this program." in said
    assert "Build its workspace again: `colcon build`." in said and "turns" not in said
