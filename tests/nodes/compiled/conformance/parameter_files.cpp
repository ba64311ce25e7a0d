// Files of parameters in C's structures, and as rclcpp takes them over.
#include <fstream>

#include "check.hpp"
#include "rcl_yaml_param_parser/parser.h"
#include "rclcpp/parameter_map.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  std::ofstream("robot.yaml") <<
    "/**:\n  ros__parameters: {speed: 1.5, name: ada}\n"
    "/front/*:\n  ros__parameters: {on: true, ids: [1, 2], parts: [a, b], marks: [true, false], lengths: [0.5]}\n";
  auto allocator = rcutils_get_default_allocator();
  rcl_params_t * params = rcl_yaml_node_struct_init(allocator);
  check("it begins empty", params && params->num_nodes == 0);
  check("a file is read", rcl_parse_yaml_file("robot.yaml", params));
  equal("two nodes' names", params->num_nodes, 2u);
  equal("a double", *rcl_yaml_node_struct_get("/**", "speed", params)->double_value, 1.5);
  equal("a text", std::string(rcl_yaml_node_struct_get("/**", "name", params)->string_value), "ada");
  check("a bool", *rcl_yaml_node_struct_get("/front/*", "on", params)->bool_value);
  auto ids = rcl_yaml_node_struct_get("/front/*", "ids", params)->integer_array_value;
  check("integers", ids->size == 2 && ids->values[1] == 2);
  auto parts = rcl_yaml_node_struct_get("/front/*", "parts", params)->string_array_value;
  check("texts", parts->size == 2 && std::string(parts->data[1]) == "b");
  check("a value is added", rcl_parse_yaml_value("/front/eye", "depth", "7", params));
  equal("it is read as in a file", *rcl_yaml_node_struct_get("/front/eye", "depth", params)->integer_value, 7);
  check("or in place of another", rcl_parse_yaml_value("/front/eye", "depth", "deep", params) && params->num_nodes == 3);
  check("of which nothing is left", !rcl_yaml_node_struct_get("/front/eye", "depth", params)->integer_value);

  auto map = rclcpp::parameter_map_from(params);
  equal("all nodes", map.size(), 3u);
  auto eye = rclcpp::parameter_map_from(params, "/front/eye");
  equal("those that fit one", eye.at("/front/eye").size(), 8u);
  auto other = rclcpp::parameter_map_from(params, "/back");
  equal("or another", other.at("/back").size(), 2u);
  equal("as from the file", rclcpp::parameter_map_from_yaml_file("robot.yaml", "/front/eye").at("/front/eye").size(), 7u);
  auto flags = rclcpp::parameter_value_from(rcl_yaml_node_struct_get("/front/*", "marks", params));
  check("a list of bools", flags.get<std::vector<bool>>() == std::vector<bool>({true, false}));

  auto copy = rcl_yaml_node_struct_copy(params);
  rcl_yaml_node_struct_fini(params);
  auto lengths = rcl_yaml_node_struct_get("/front/*", "lengths", copy)->double_array_value;
  check("a copy has its own", copy->num_nodes == 3 && lengths->values[0] == 0.5);
  throws<rclcpp::exceptions::InvalidParameterValueException>("an empty value", [&] {
      rclcpp::parameter_value_from(rcl_yaml_node_struct_get("/front/*", "nothing", copy));
    });
  throws<rclcpp::exceptions::InvalidParameterValueException>("no value", [] {rclcpp::parameter_value_from(nullptr);});
  throws<rclcpp::exceptions::InvalidParametersException>("no parameters", [] {rclcpp::parameter_map_from(nullptr);});
  check("no file", !rcl_parse_yaml_file("nothing.yaml", copy));
  check("says why", rcutils_error_is_set() && std::string(rcl_get_error_string().str).find("nothing.yaml") != std::string::npos);
  rcl_reset_error();
  check("until that is forgotten", !rcutils_error_is_set());
  check("no YAML", !rcl_parse_yaml_value("/front/eye", "depth", "[1, a]", copy));
  rcl_yaml_node_struct_fini(copy);
  rclcpp::shutdown();
}
