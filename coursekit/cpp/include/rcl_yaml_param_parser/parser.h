// Files of parameters, read into C's structures by the session. What fails says why by rcutils_get_error_string().
#pragma once
#include "rcl_yaml_param_parser/types.h"
#include "rcutils/error_handling.h"

rcl_params_t * rcl_yaml_node_struct_init(rcutils_allocator_t allocator);
rcl_params_t * rcl_yaml_node_struct_init_with_capacity(size_t capacity, rcutils_allocator_t allocator);
rcl_params_t * rcl_yaml_node_struct_copy(const rcl_params_t * params);
void rcl_yaml_node_struct_fini(rcl_params_t * params);
/// Add what a file says.
bool rcl_parse_yaml_file(const char * file_path, rcl_params_t * params);
/// Add a parameter of a node, with its value as YAML.
bool rcl_parse_yaml_value(const char * node_name, const char * param_name, const char * yaml_value, rcl_params_t * params);
/// A parameter's value, which is made empty where there is none yet; the pointer holds until the next is added.
rcl_variant_t * rcl_yaml_node_struct_get(const char * node_name, const char * param_name, rcl_params_t * params);
void rcl_yaml_node_struct_print(const rcl_params_t * params);
