"""A chain of filters that a C++ program loads from a library of its package."""

from __future__ import annotations

import pytest

from tests.needs import compiler_or_skip
from tests.packages.test_cpp_workspace import colcon, sourced

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]
MANIFEST = """<?xml version="1.0"?>
<package format="3"><name>k_halve</name><version>0.1.0</version><description>Halves.</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license><buildtool_depend>ament_cmake</buildtool_depend>
<depend>filters</depend><export><build_type>ament_cmake</build_type></export></package>
"""
CMAKE = """
cmake_minimum_required(VERSION 3.8)
project(k_halve)
find_package(ament_cmake REQUIRED)
find_package(filters REQUIRED)
find_package(pluginlib REQUIRED)
add_library(halve SHARED halve.cpp)
ament_target_dependencies(halve filters)
pluginlib_export_plugin_description_file(filters halve.xml)
add_executable(chain chain.cpp)
ament_target_dependencies(chain filters)
install(TARGETS halve DESTINATION lib)
install(TARGETS chain DESTINATION lib/${PROJECT_NAME})
ament_package()
"""
PLUGINS = """<library path="halve">
  <class name="k_halve/Halve" type="Halve" base_class_type="filters::FilterBase&lt;double&gt;"/>
</library>
"""
HALVE = """
#include "filters/filter_base.hpp"
#include "pluginlib/class_list_macros.hpp"
class Halve : public filters::FilterBase<double>
{
public:
  bool configure() override {return getParam("by", by_);}
  bool update(const double & data_in, double & data_out) override
  {
    data_out = data_in / by_;
    return true;
  }

private:
  double by_ = 1;
};
PLUGINLIB_EXPORT_CLASS(Halve, filters::FilterBase<double>)
"""
CHAIN = """
#include "filters/filter_chain.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared(
    "chain", rclcpp::NodeOptions().parameter_overrides(
      {{"filter1.name", "first"}, {"filter1.type", "k_halve/Halve"}, {"filter1.params.by", 4.0},
        {"filter2.name", "second"}, {"filter2.type", "k_halve/Halve"}, {"filter2.params.by", 2.0}}));
  filters::FilterChain<double> chain("double");
  bool ready = chain.configure("", node->get_node_logging_interface(), node->get_node_parameters_interface());
  double out = 0;
  std::cout << ready << chain.update(12.0, out) << " " << out << std::endl;
}
"""


def test_a_chain_loads_its_filters_and_passes_values_through(tmp_path):
    compiler_or_skip()
    folder = tmp_path / "src" / "k_halve"
    folder.mkdir(parents=True)
    texts = {"package.xml": MANIFEST, "CMakeLists.txt": CMAKE, "halve.xml": PLUGINS, "halve.cpp": HALVE, "chain.cpp": CHAIN}
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")
    built = colcon(tmp_path, "build")
    assert built.returncode == 0, built.stdout + built.stderr
    ran = sourced(tmp_path, "ros2 run k_halve chain")
    assert ran.stdout.strip() == "11 1.5", ran.stdout + ran.stderr
