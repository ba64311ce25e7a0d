// A node's parameters, asked of the session; and parameters as text.
#include <sstream>

#include "rclcpp/rclcpp.hpp"

namespace rclcpp
{
using node_interfaces::NodeBaseInterface;
using node_interfaces::OnSetParametersCallbackHandle;
using rcl_interfaces::msg::ParameterDescriptor;
using rcl_interfaces::msg::SetParametersResult;

const ParameterValue & NodeBaseInterface::declare_parameter(
  const std::string & name, const ParameterValue & default_value, const ParameterDescriptor & descriptor, bool ignore_override)
{
  if (name.empty()) {
    throw exceptions::InvalidParametersException("parameter name must not be empty");
  }
  if (default_value.get_type() == PARAMETER_NOT_SET && !descriptor.dynamic_typing) {
    throw exceptions::InvalidParameterTypeException(
            name, "cannot declare a statically typed parameter with an uninitialized value");
  }
  Packer with = Packer{}.i(id).s(name).i(0).m(default_value.to_value_msg()).m(descriptor).i(ignore_override);
  return declared_[name] = ParameterValue(ask("declare", with).m<rcl_interfaces::msg::ParameterValue>());
}
const ParameterValue & NodeBaseInterface::declare_parameter(
  const std::string & name, ParameterType type, const ParameterDescriptor & descriptor, bool ignore_override)
{
  if (type == PARAMETER_NOT_SET) {
    throw std::invalid_argument("declare_parameter(): the provided parameter type cannot be rclcpp::PARAMETER_NOT_SET");
  }
  if (descriptor.dynamic_typing) {
    throw std::invalid_argument(
            "declare_parameter(): cannot declare parameter of specific type and pass descriptor with `dynamic_typing=true`");
  }
  Packer with = Packer{}.i(id).s(name).i(type).m(rcl_interfaces::msg::ParameterValue()).m(descriptor).i(ignore_override);
  return declared_[name] = ParameterValue(ask("declare", with).m<rcl_interfaces::msg::ParameterValue>());
}
ParameterMap detail::parameter_file(const std::string & path, const std::string & node)
{
  Unpacker answer = ask("parameter_file", Packer{}.s(path).s(node));
  ParameterMap map;
  for (int64_t nodes = answer.i(); nodes > 0; --nodes) {
    auto & parameters = map[answer.s()];
    for (int64_t count = answer.i(); count > 0; --count) {
      parameters.push_back(Parameter::from_parameter_msg(answer.m<rcl_interfaces::msg::Parameter>()));
    }
  }
  return map;
}
void NodeBaseInterface::undeclare_parameter(const std::string & name)
{
  if (has_parameter(name)) {
    auto descriptor = describe_parameter(name);
    if (!descriptor.read_only && !descriptor.dynamic_typing) {
      throw exceptions::InvalidParameterTypeException(name, "cannot undeclare an statically typed parameter");
    }
  }
  ask("undeclare", Packer{}.i(id).s(name));
}
bool NodeBaseInterface::has_parameter(const std::string & name) const
{
  return ask("has_parameter", Packer{}.i(id).s(name)).i();
}
Parameter NodeBaseInterface::get_parameter(const std::string & name) const
{
  return Parameter::from_parameter_msg(
    ask("get_parameter", Packer{}.i(id).s(name)).m<rcl_interfaces::msg::Parameter>());
}
bool NodeBaseInterface::get_parameter(const std::string & name, Parameter & parameter) const
{
  Unpacker answer = ask("find_parameter", Packer{}.i(id).s(name));
  bool known = answer.i();
  if (known) {
    parameter = Parameter::from_parameter_msg(answer.m<rcl_interfaces::msg::Parameter>());
  }
  return known;
}
std::vector<Parameter> NodeBaseInterface::get_parameters(const std::vector<std::string> & names) const
{
  std::vector<Parameter> parameters;
  for (auto & name : names) {
    parameters.push_back(get_parameter(name));
  }
  return parameters;
}
bool NodeBaseInterface::get_parameters_by_prefix(const std::string & prefix, std::map<std::string, Parameter> & parameters) const
{
  std::string start = prefix.empty() ? "" : prefix + ".";
  bool any = false;
  const auto prefixes = prefix.empty() ? std::vector<std::string>() : std::vector<std::string>{prefix};
  for (auto & name : list_parameters(prefixes, 0).names) {
    if (name.compare(0, start.size(), start) == 0) {
      Parameter found(name);
      get_parameter(name, found);
      parameters[name.substr(start.size())] = found;
      any = true;
    }
  }
  return any;
}
SetParametersResult NodeBaseInterface::set_parameter(const Parameter & parameter) {return set({parameter}, false)[0];}
std::vector<SetParametersResult> NodeBaseInterface::set_parameters(const std::vector<Parameter> & parameters)
{
  return set(parameters, false);
}
SetParametersResult NodeBaseInterface::set_parameters_atomically(const std::vector<Parameter> & parameters)
{
  return set(parameters, true)[0];
}
std::vector<SetParametersResult> NodeBaseInterface::set(const std::vector<Parameter> & parameters, bool together)
{
  Packer with = Packer{}.i(id).i(together).i(static_cast<int64_t>(parameters.size()));
  for (auto & parameter : parameters) {
    with.m(parameter.to_parameter_msg());
  }
  Unpacker answer = ask("set_parameters", with);
  std::vector<SetParametersResult> results(static_cast<size_t>(answer.i()));
  for (auto & result : results) {
    result = answer.m<SetParametersResult>();
  }
  return results;
}
ParameterDescriptor NodeBaseInterface::describe_parameter(const std::string & name) const
{
  auto descriptor = ask("describe_parameter", Packer{}.i(id).s(name)).m<ParameterDescriptor>();
  descriptor.name = name;  // of one that is not declared, where that is allowed, there is nothing else
  return descriptor;
}
std::vector<ParameterDescriptor> NodeBaseInterface::describe_parameters(const std::vector<std::string> & names) const
{
  std::vector<ParameterDescriptor> descriptors;
  for (auto & name : names) {
    descriptors.push_back(describe_parameter(name));
  }
  return descriptors;
}
std::vector<uint8_t> NodeBaseInterface::get_parameter_types(const std::vector<std::string> & names) const
{
  std::vector<uint8_t> types;
  for (auto & name : names) {
    Parameter found;
    if (!get_parameter(name, found)) {
      describe_parameter(name);  // throws where it must be declared
    }
    types.push_back(found.get_type());
  }
  return types;
}
rcl_interfaces::msg::ListParametersResult NodeBaseInterface::list_parameters(
  const std::vector<std::string> & prefixes, uint64_t depth) const
{
  Packer with = Packer{}.i(id).i(static_cast<int64_t>(depth)).i(static_cast<int64_t>(prefixes.size()));
  for (auto & prefix : prefixes) {
    with.s(prefix);
  }
  return ask("list_parameters", with).m<rcl_interfaces::msg::ListParametersResult>();
}
OnSetParametersCallbackHandle::SharedPtr NodeBaseInterface::add_on_set_parameters_callback(
  OnParametersSetCallbackType callback)
{
  auto made = std::make_shared<OnSetParametersCallbackHandle>();
  made->callback = callback;
  int64_t handler = made->handle(
    [callback](Unpacker & from, Packer & to) {
      std::vector<Parameter> parameters;
      for (int64_t count = from.i(); count > 0; --count) {
        parameters.push_back(Parameter::from_parameter_msg(from.m<rcl_interfaces::msg::Parameter>()));
      }
      to.m(callback(parameters));
    });
  made->id = ask("on_set_parameters", Packer{}.i(id).i(handler)).i();
  return made;
}
void NodeBaseInterface::remove_on_set_parameters_callback(const OnSetParametersCallbackHandle * handle)
{
  if (!ask("remove_on_set_parameters", Packer{}.i(handle->id)).i()) {
    throw std::runtime_error("Callback doesn't exist");
  }
}

// -- as text

std::string to_string(ParameterType type)
{
  static const char * const names[] = {
    "not set", "bool", "integer", "double", "string", "byte_array", "bool_array", "integer_array", "double_array", "string_array"};
  return type <= PARAMETER_STRING_ARRAY ? names[type] : "unknown type";
}
std::ostream & operator<<(std::ostream & stream, ParameterType type) {return stream << to_string(type);}
namespace
{
template<class V>
std::string listed(const V & items)
{
  std::ostringstream text;
  text << std::boolalpha << "[";
  for (size_t i = 0; i < items.size(); ++i) {
    text << (i ? ", " : "") << items[i];
  }
  text << "]";
  return text.str();
}
std::string listed_bytes(const std::vector<uint8_t> & items)
{
  std::ostringstream text;
  text << std::hex << "[";
  for (size_t i = 0; i < items.size(); ++i) {
    text << (i ? ", " : "") << "0x" << static_cast<int>(items[i]);
  }
  text << "]";
  return text.str();
}
}  // namespace
std::string to_string(const ParameterValue & value)
{
  auto & message = value.to_value_msg();
  switch (value.get_type()) {
    case PARAMETER_NOT_SET: return "not set";
    case PARAMETER_BOOL: return message.bool_value ? "true" : "false";
    case PARAMETER_INTEGER: return std::to_string(message.integer_value);
    case PARAMETER_DOUBLE: return std::to_string(message.double_value);
    case PARAMETER_STRING: return message.string_value;
    case PARAMETER_BYTE_ARRAY: return listed_bytes(message.byte_array_value);
    case PARAMETER_BOOL_ARRAY: return listed(message.bool_array_value);
    case PARAMETER_INTEGER_ARRAY: return listed(message.integer_array_value);
    case PARAMETER_DOUBLE_ARRAY: return listed(message.double_array_value);
    case PARAMETER_STRING_ARRAY: return listed(message.string_array_value);
    default: return "unknown type";
  }
}
std::ostream & operator<<(std::ostream & stream, const ParameterValue & value) {return stream << to_string(value);}
std::ostream & operator<<(std::ostream & stream, const Parameter & parameter)
{
  return stream << "{\"name\": \"" << parameter.get_name() << "\", \"type\": \"" << parameter.get_type_name() <<
         "\", \"value\": \"" << parameter.value_to_string() << "\"}";
}
std::ostream & operator<<(std::ostream & stream, const std::vector<Parameter> & parameters)
{
  return stream << std::to_string(parameters);
}
std::string _to_json_dict_entry(const Parameter & parameter)
{
  std::ostringstream text;
  text << '"' << parameter.get_name() << "\": {\"type\": \"" << parameter.get_type_name() << "\", \"value\": \"" <<
    parameter.value_to_string() << "\"}";
  return text.str();
}
std::string qos_policy_name_from_kind(rmw_qos_policy_kind_t kind)
{
  switch (kind) {
    case RMW_QOS_POLICY_DURABILITY: return "DURABILITY_QOS_POLICY";
    case RMW_QOS_POLICY_DEADLINE: return "DEADLINE_QOS_POLICY";
    case RMW_QOS_POLICY_LIVELINESS: return "LIVELINESS_QOS_POLICY";
    case RMW_QOS_POLICY_RELIABILITY: return "RELIABILITY_QOS_POLICY";
    case RMW_QOS_POLICY_HISTORY: return "HISTORY_QOS_POLICY";
    case RMW_QOS_POLICY_LIFESPAN: return "LIFESPAN_QOS_POLICY";
    case RMW_QOS_POLICY_DEPTH: return "DEPTH_QOS_POLICY";
    case RMW_QOS_POLICY_LIVELINESS_LEASE_DURATION: return "LIVELINESS_LEASE_DURATION_QOS_POLICY";
    case RMW_QOS_POLICY_AVOID_ROS_NAMESPACE_CONVENTIONS: return "AVOID_ROS_NAMESPACE_CONVENTIONS_QOS_POLICY";
    default: return "INVALID_QOS_POLICY";
  }
}
}  // namespace rclcpp

std::string std::to_string(const rclcpp::Parameter & parameter)
{
  std::ostringstream text;
  text << parameter;
  return text.str();
}
std::string std::to_string(const std::vector<rclcpp::Parameter> & parameters)
{
  std::ostringstream text;
  text << "{";
  for (size_t i = 0; i < parameters.size(); ++i) {
    text << (i ? ", " : "") << rclcpp::_to_json_dict_entry(parameters[i]);
  }
  text << "}";
  return text.str();
}
