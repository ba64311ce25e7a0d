// Parameters in C's structures: filled by the session's reading of YAML, and taken over by rclcpp.
#include <regex>

#include "rcl_yaml_param_parser/parser.h"
#include "rclcpp/parameter_map.hpp"
#include "rcpputils/find_and_replace.hpp"

namespace
{
using rclcpp::ParameterValue;

/// An array with room for one more, of which all but the zeros are as before.
template<class T>
T * grown(T * items, size_t count)
{
  auto more = static_cast<T *>(realloc(static_cast<void *>(items), (count + 1) * sizeof(T)));
  if (!more) {
    throw std::bad_alloc();
  }
  memset(static_cast<void *>(more + count), 0, sizeof(T));
  return more;
}
template<class T>
T * kept(const T & value)
{
  T * made = grown<T>(nullptr, 0);
  *made = value;
  return made;
}
template<class Array, class V>
Array * kept_array(const V & items)
{
  Array array{nullptr, items.size()};
  array.values = static_cast<decltype(array.values)>(malloc((items.size() + 1) * sizeof(*array.values)));
  std::copy(items.begin(), items.end(), array.values);
  return kept(array);
}
rcutils_string_array_t * kept_texts(const std::vector<std::string> & texts)
{
  auto array = rcutils_get_zero_initialized_string_array();
  const auto allocator = rcutils_get_default_allocator();
  rcutils_string_array_init(&array, texts.size(), &allocator);
  for (size_t i = 0; i < texts.size(); ++i) {
    array.data[i] = strdup(texts[i].c_str());
  }
  return kept(array);
}

template<class Array>
void free_array(Array * array)
{
  if (array) {
    free(array->values);
  }
  free(array);
}
void clear(rcl_variant_t & variant)
{
  free(variant.bool_value);
  free(variant.integer_value);
  free(variant.double_value);
  free(variant.string_value);
  free_array(variant.byte_array_value);
  free_array(variant.bool_array_value);
  free_array(variant.integer_array_value);
  free_array(variant.double_array_value);
  if (variant.string_array_value) {
    static_cast<void>(rcutils_string_array_fini(variant.string_array_value));
  }
  free(variant.string_array_value);
  variant = {};
}
void assign(rcl_variant_t & variant, const rcl_interfaces::msg::ParameterValue & value)
{
  clear(variant);
  switch (value.type) {
    case rclcpp::PARAMETER_BOOL: variant.bool_value = kept(value.bool_value); break;
    case rclcpp::PARAMETER_INTEGER: variant.integer_value = kept(value.integer_value); break;
    case rclcpp::PARAMETER_DOUBLE: variant.double_value = kept(value.double_value); break;
    case rclcpp::PARAMETER_STRING: variant.string_value = strdup(value.string_value.c_str()); break;
    case rclcpp::PARAMETER_BYTE_ARRAY: variant.byte_array_value = kept_array<rcl_byte_array_t>(value.byte_array_value); break;
    case rclcpp::PARAMETER_BOOL_ARRAY: variant.bool_array_value = kept_array<rcl_bool_array_t>(value.bool_array_value); break;
    case rclcpp::PARAMETER_INTEGER_ARRAY:
      variant.integer_array_value = kept_array<rcl_int64_array_t>(value.integer_array_value);
      break;
    case rclcpp::PARAMETER_DOUBLE_ARRAY:
      variant.double_array_value = kept_array<rcl_double_array_t>(value.double_array_value);
      break;
    case rclcpp::PARAMETER_STRING_ARRAY: variant.string_array_value = kept_texts(value.string_array_value); break;
    default: break;
  }
}
template<class Array>
auto items_of(const Array & array)
{
  return std::vector<std::remove_pointer_t<decltype(array.values)>>(array.values, array.values + array.size);
}

/// Where a name stands in a list, in which it is put where it is not there.
size_t place_of(const char * name, char ** & names, size_t & count, size_t & capacity, bool & is_new)
{
  size_t at = 0;
  while (at < count && strcmp(names[at], name) != 0) {
    ++at;
  }
  is_new = at == count;
  if (is_new) {
    names = grown(names, count);
    names[count++] = strdup(name);
    capacity = count;
  }
  return at;
}
/// Do what may fail for a reason that C's callers ask for.
template<class F>
bool tried(F what)
{
  try {
    what();
    return true;
  } catch (const std::exception & error) {
    RCUTILS_SET_ERROR_MSG(error.what());
    return false;
  }
}
}  // namespace

rcl_params_t * rcl_yaml_node_struct_init(rcutils_allocator_t) {return static_cast<rcl_params_t *>(calloc(1, sizeof(rcl_params_t)));}
rcl_params_t * rcl_yaml_node_struct_init_with_capacity(size_t, rcutils_allocator_t allocator)
{
  return rcl_yaml_node_struct_init(allocator);  // it grows with what is added
}
void rcl_yaml_node_struct_fini(rcl_params_t * params)
{
  for (size_t n = 0; params && n < params->num_nodes; ++n) {
    auto & node = params->params[n];
    for (size_t p = 0; p < node.num_params; ++p) {
      clear(node.parameter_values[p]);
      free(node.parameter_names[p]);
    }
    free(node.parameter_names);
    free(node.parameter_values);
    free(params->node_names[n]);
  }
  if (params) {
    free(params->params);
    free(params->node_names);
  }
  free(params);
}
rcl_variant_t * rcl_yaml_node_struct_get(const char * node_name, const char * param_name, rcl_params_t * params)
{
  if (!node_name || !param_name || !params) {
    return nullptr;
  }
  bool is_new;
  size_t n = place_of(node_name, params->node_names, params->num_nodes, params->capacity_nodes, is_new);
  params->params = is_new ? grown(params->params, n) : params->params;
  auto & node = params->params[n];
  size_t p = place_of(param_name, node.parameter_names, node.num_params, node.capacity_params, is_new);
  node.parameter_values = is_new ? grown(node.parameter_values, p) : node.parameter_values;
  return &node.parameter_values[p];
}
bool rcl_parse_yaml_file(const char * file_path, rcl_params_t * params)
{
  if (!file_path || !params) {
    RCUTILS_SET_ERROR_MSG(file_path ? "Pass an initialized parameter structure" : "YAML file path is NULL");
    return false;
  }
  return tried([&] {
             for (auto & [node, parameters] : rclcpp::detail::parameter_file(file_path, "")) {
               for (auto & parameter : parameters) {
                 assign(
                   *rcl_yaml_node_struct_get(node.c_str(), parameter.get_name().c_str(), params), parameter.get_value_message());
               }
             }
           });
}
bool rcl_parse_yaml_value(const char * node_name, const char * param_name, const char * yaml_value, rcl_params_t * params)
{
  if (!node_name || !param_name || !yaml_value || !params || !*node_name || !*param_name || !*yaml_value) {
    RCUTILS_SET_ERROR_MSG("rcl_parse_yaml_value() needs a node's name, a parameter's name, a value and a structure");
    return false;
  }
  return tried([&] {
             auto read = rclcpp::ask("parameter_value", rclcpp::Packer{}.s(yaml_value));
             assign(*rcl_yaml_node_struct_get(node_name, param_name, params), read.m<rcl_interfaces::msg::ParameterValue>());
           });
}
rcl_params_t * rcl_yaml_node_struct_copy(const rcl_params_t * params)
{
  if (!params) {
    return nullptr;
  }
  auto copy = rcl_yaml_node_struct_init(params->allocator);
  for (size_t n = 0; n < params->num_nodes; ++n) {
    auto & node = params->params[n];
    for (size_t p = 0; p < node.num_params; ++p) {
      assign(
        *rcl_yaml_node_struct_get(params->node_names[n], node.parameter_names[p], copy),
        rclcpp::parameter_value_from(&node.parameter_values[p]).to_value_msg());
    }
  }
  return copy;
}
void rcl_yaml_node_struct_print(const rcl_params_t * params)
{
  for (size_t n = 0; params && n < params->num_nodes; ++n) {
    printf("%s:\n", params->node_names[n]);
    auto & node = params->params[n];
    for (size_t p = 0; p < node.num_params; ++p) {
      const std::string value = to_string(rclcpp::parameter_value_from(&node.parameter_values[p]));
      printf("  %s: %s\n", node.parameter_names[p], value.c_str());
    }
  }
}

namespace rclcpp
{
ParameterValue parameter_value_from(const rcl_variant_t * value)
{
  if (!value) {
    throw exceptions::InvalidParameterValueException("Passed argument is NULL");
  }
  ParameterValue found;
  auto take = [&](const auto * given, auto as_value) {
      if (given) {
        found = ParameterValue(as_value(given));
      }
    };
  auto itself = [](auto given) {return *given;};
  auto items = [](auto given) {return items_of(*given);};
  take(value->bool_value, itself);
  take(value->integer_value, itself);
  take(value->double_value, itself);
  take(value->string_value, [](const char * text) {return std::string(text);});
  take(value->byte_array_value, items);
  take(value->bool_array_value, items);
  take(value->integer_array_value, items);
  take(value->double_array_value, items);
  take(value->string_array_value, [](auto all) {return std::vector<std::string>(all->data, all->data + all->size);});
  if (found.get_type() == PARAMETER_NOT_SET) {
    throw exceptions::InvalidParameterValueException("No parameter value set");
  }
  return found;
}
ParameterMap parameter_map_from(const rcl_params_t * params, const char * node_fqn)
{
  if (!params || !params->node_names || !params->params) {
    throw exceptions::InvalidParametersException(params ? "node names array is NULL" : "parameters struct is NULL");
  }
  ParameterMap map;
  for (size_t n = 0; n < params->num_nodes; ++n) {
    const std::string written = params->node_names[n], name = written.front() == '/' ? written : "/" + written;
    const std::regex pattern(rcpputils::find_and_replace(name, "/*", "(/\\w+)"));  // and so "/**" is any number of names
    if (node_fqn && !std::regex_match(node_fqn, pattern)) {
      continue;
    }
    auto & parameters = map[node_fqn ? node_fqn : name];
    auto & node = params->params[n];
    for (size_t p = 0; p < node.num_params; ++p) {
      parameters.emplace_back(node.parameter_names[p], parameter_value_from(&node.parameter_values[p]));
    }
  }
  return map;
}
}  // namespace rclcpp
