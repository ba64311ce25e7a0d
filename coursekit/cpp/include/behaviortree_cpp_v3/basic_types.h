// States of nodes, what their ports are, and how texts become values.
#pragma once
#include <chrono>
#include <functional>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <typeinfo>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "behaviortree_cpp_v3/exceptions.h"
#include "behaviortree_cpp_v3/utils/expected.hpp"
#include "behaviortree_cpp_v3/utils/make_unique.hpp"
#include "behaviortree_cpp_v3/utils/safe_any.hpp"
#include "behaviortree_cpp_v3/utils/string_view.hpp"

namespace BT
{
enum class NodeType
{
  UNDEFINED = 0,
  ACTION,
  CONDITION,
  CONTROL,
  DECORATOR,
  SUBTREE
};
enum class NodeStatus
{
  IDLE = 0,
  RUNNING,
  SUCCESS,
  FAILURE
};
enum class PortDirection
{
  INPUT,
  OUTPUT,
  INOUT
};
using StringView = nonstd::string_view;
using TimePoint = std::chrono::high_resolution_clock::time_point;
using Duration = std::chrono::high_resolution_clock::duration;

template<class T>
using Optional = nonstd::expected<T, std::string>;
using Result = Optional<void>;

inline bool StatusCompleted(const NodeStatus & status)
{
  return status == NodeStatus::SUCCESS || status == NodeStatus::FAILURE;
}

/// Read a text in a tree as a value: programs specialize it for their own types.
template<class T>
inline T convertFromString(StringView)
{
  const std::string type = demangle(typeid(T));
  std::cerr << "BT::convertFromString() has no specialization for the type [" << type << "]" << std::endl;
  throw LogicError("You didn't implement the template specialization of convertFromString for this type: ", type);
}
template<>
std::string convertFromString<std::string>(StringView text);
template<>
const char * convertFromString<const char *>(StringView text);
template<>
int convertFromString<int>(StringView text);
template<>
unsigned convertFromString<unsigned>(StringView text);
template<>
long convertFromString<long>(StringView text);  // NOLINT
template<>
unsigned long convertFromString<unsigned long>(StringView text);  // NOLINT
template<>
float convertFromString<float>(StringView text);
template<>
double convertFromString<double>(StringView text);
/// Numbers between semicolons.
template<>
std::vector<int> convertFromString<std::vector<int>>(StringView text);
template<>
std::vector<double> convertFromString<std::vector<double>>(StringView text);
/// 0, 1, true, false, True, False, TRUE or FALSE.
template<>
bool convertFromString<bool>(StringView text);
template<>
NodeStatus convertFromString<NodeStatus>(StringView text);
template<>
NodeType convertFromString<NodeType>(StringView text);
template<>
PortDirection convertFromString<PortDirection>(StringView text);

using StringConverter = std::function<Any (StringView)>;
using StringConvertersMap = std::unordered_map<const std::type_info *, StringConverter>;

template<class T>
inline StringConverter GetAnyFromStringFunctor()
{
  if constexpr (std::is_void_v<T>) {
    return {};
  } else {
    return [](StringView text) {return Any(convertFromString<T>(text));};
  }
}

template<class T>
std::string toStr(T value) {return std::to_string(value);}
std::string toStr(std::string value);
template<>
std::string toStr<NodeStatus>(NodeStatus status);
template<>
std::string toStr<NodeType>(NodeType type);
template<>
std::string toStr<PortDirection>(PortDirection direction);
/// In a terminal's colours, if wanted.
std::string toStr(NodeStatus status, bool colored);
std::ostream & operator<<(std::ostream & to, const NodeStatus & status);
std::ostream & operator<<(std::ostream & to, const NodeType & type);
std::ostream & operator<<(std::ostream & to, const PortDirection & direction);

std::vector<StringView> splitString(const StringView & text, char delimiter);
/// Whether an attribute of a node is none of its ports.
bool IsReservedPortname(StringView name);

class PortInfo
{
public:
  explicit PortInfo(PortDirection direction = PortDirection::INOUT)
  : direction_(direction) {}
  PortInfo(PortDirection direction, const std::type_info & type, StringConverter converter)
  : direction_(direction), type_(&type), converter_(std::move(converter)) {}

  PortDirection direction() const {return direction_;}
  /// nullptr for a port that takes any type.
  const std::type_info * type() const {return type_;}
  bool isStronglyTyped() const {return type_ != nullptr;}
  /// Empty where the text cannot be read so.
  Any parseString(const char * text) const {return parse(text);}
  Any parseString(const std::string & text) const {return parse(text);}
  template<class T>
  Any parseString(const T &) const {return {};}

  void setDescription(StringView description) {description_ = description;}
  void setDefaultValue(StringView value) {default_value_ = value;}
  const std::string & description() const {return description_;}
  const std::string & defaultValue() const {return default_value_;}

private:
  Any parse(StringView text) const;

  PortDirection direction_;
  const std::type_info * type_ = nullptr;
  StringConverter converter_;
  std::string description_;
  std::string default_value_;
};
using PortsList = std::unordered_map<std::string, PortInfo>;

template<class T = void>
std::pair<std::string, PortInfo> CreatePort(PortDirection direction, StringView name, StringView description = {})
{
  if (IsReservedPortname(name)) {
    throw std::runtime_error("A port can not use a reserved name. See ReservedPortNames");
  }
  PortInfo info(direction);
  if constexpr (!std::is_void_v<T>) {
    info = PortInfo(direction, typeid(T), GetAnyFromStringFunctor<T>());
  }
  info.setDescription(description);
  return {std::string(name), info};
}
template<class T>
std::pair<std::string, PortInfo> CreatePort(
  PortDirection direction, StringView name, const T & value, StringView description)
{
  auto port = CreatePort<T>(direction, name, description);
  port.second.setDefaultValue(BT::toStr(value));
  return port;
}
template<class T = void>
std::pair<std::string, PortInfo> InputPort(StringView name, StringView description = {})
{
  return CreatePort<T>(PortDirection::INPUT, name, description);
}
template<class T = void>
std::pair<std::string, PortInfo> OutputPort(StringView name, StringView description = {})
{
  return CreatePort<T>(PortDirection::OUTPUT, name, description);
}
template<class T = void>
std::pair<std::string, PortInfo> BidirectionalPort(StringView name, StringView description = {})
{
  return CreatePort<T>(PortDirection::INOUT, name, description);
}
template<class T = void>
std::pair<std::string, PortInfo> InputPort(StringView name, const T & default_value, StringView description)
{
  return CreatePort<T>(PortDirection::INPUT, name, default_value, description);
}
template<class T = void>
std::pair<std::string, PortInfo> BidirectionalPort(StringView name, const T & default_value, StringView description)
{
  return CreatePort<T>(PortDirection::INOUT, name, default_value, description);
}

template<class T, class = void>
struct has_static_method_providedPorts : std::false_type {};
template<class T>
struct has_static_method_providedPorts<
  T, std::enable_if_t<std::is_same_v<decltype(T::providedPorts()), PortsList>>>: std::true_type {};

template<class T>
PortsList getProvidedPorts()
{
  if constexpr (has_static_method_providedPorts<T>::value) {
    return T::providedPorts();
  } else {
    return {};
  }
}
}  // namespace BT
