// What C's functions tell of a node; its handle is the node's interface.
#pragma once
#include "rclcpp/node_interfaces/node_base_interface.hpp"

using rcl_node_t = rclcpp::node_interfaces::NodeBaseInterface;
using rmw_node_t = rcl_node_t;

inline const char * rcl_node_get_name(const rcl_node_t * node) {return node ? node->get_name() : nullptr;}
inline const char * rcl_node_get_namespace(const rcl_node_t * node) {return node ? node->get_namespace() : nullptr;}
inline const char * rcl_node_get_fully_qualified_name(const rcl_node_t * node)
{
  return node ? node->get_fully_qualified_name() : nullptr;
}
inline const char * rcl_node_get_logger_name(const rcl_node_t * node) {return node ? node->get_logger_name() : nullptr;}
inline rmw_node_t * rcl_node_get_rmw_handle(const rcl_node_t * node) {return const_cast<rmw_node_t *>(node);}
inline bool rcl_node_is_valid(const rcl_node_t * node) {return node && node->context->is_valid();}
