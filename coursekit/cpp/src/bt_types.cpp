// Trees' values: texts, numbers and the states of nodes.
#include <algorithm>
#include <array>
#include <limits>

#include "behaviortree_cpp_v3/basic_types.h"

#ifdef __GNUG__
#include <cxxabi.h>

#include <cstdlib>
#endif

namespace BT
{
namespace
{
template<class T>
struct Name
{
  T value;
  const char * text;
  const char * color = "";
};
constexpr std::array<Name<NodeStatus>, 4> STATUSES{{
  {NodeStatus::IDLE, "IDLE", "\x1b[36m"},
  {NodeStatus::RUNNING, "RUNNING", "\x1b[33m"},
  {NodeStatus::SUCCESS, "SUCCESS", "\x1b[32m"},
  {NodeStatus::FAILURE, "FAILURE", "\x1b[31m"},
}};
constexpr std::array<Name<NodeType>, 6> TYPES{{
  {NodeType::ACTION, "Action"},
  {NodeType::CONDITION, "Condition"},
  {NodeType::CONTROL, "Control"},
  {NodeType::DECORATOR, "Decorator"},
  {NodeType::SUBTREE, "SubTree"},
  {NodeType::UNDEFINED, "Undefined"},
}};
constexpr std::array<Name<PortDirection>, 3> DIRECTIONS{{
  {PortDirection::INPUT, "Input"},
  {PortDirection::OUTPUT, "Output"},
  {PortDirection::INOUT, "InOut"},
}};

template<class T, size_t N>
const Name<T> & named(const std::array<Name<T>, N> & names, T value)
{
  static constexpr Name<T> unknown{{}, "Undefined"};
  auto found = std::find_if(names.begin(), names.end(), [value](const auto & one) {return one.value == value;});
  return found == names.end() ? unknown : *found;
}
template<class T, size_t N>
T read(const std::array<Name<T>, N> & names, StringView text, const char * kind)
{
  for (auto & one : names) {
    if (text == one.text) {
      return one.value;
    }
  }
  throw RuntimeError("Cannot convert this to ", kind, ": ", text);
}
template<class T>
std::vector<T> numbers(StringView text)
{
  std::vector<T> all;
  for (StringView part : splitString(text, ';')) {
    all.push_back(convertFromString<T>(part));
  }
  return all;
}
}  // namespace

std::string demangle(const std::type_info & type)
{
  if (type == typeid(std::string)) {
    return "std::string";
  }
#ifdef __GNUG__
  int status = 0;
  std::unique_ptr<char, void (*)(void *)> name(abi::__cxa_demangle(type.name(), nullptr, nullptr, &status), std::free);
  if (status == 0) {
    return name.get();
  }
#endif
  return type.name();
}
std::string demangle(const std::type_info * type) {return type ? demangle(*type) : "void";}

std::runtime_error Any::failure(const std::type_info & as) const
{
  return std::runtime_error(
    "[Any::convert]: no known safe conversion between [" + demangle(type()) + "] and [" + demangle(as) + "]");
}
int64_t Any::as_integer(const std::type_info & as) const
{
  if (is<uint64_t>()) {
    return static_cast<int64_t>(std::any_cast<uint64_t>(value_));
  }
  return is<int64_t>() ? std::any_cast<int64_t>(value_) : throw failure(as);
}
bool Any::as_bool() const
{
  const double number = isNumber() ? as_number<double>() : throw failure(typeid(bool));
  if (number != 0 && number != 1) {
    throw std::runtime_error("Implicit casting to bool is not allowed");
  }
  return number != 0;
}
std::string Any::number_as_text(const std::type_info & as) const
{
  if (is<int64_t>()) {
    return std::to_string(std::any_cast<int64_t>(value_));
  }
  if (is<uint64_t>()) {
    return std::to_string(std::any_cast<uint64_t>(value_));
  }
  return is<double>() ? std::to_string(std::any_cast<double>(value_)) : throw failure(as);
}

template<>
std::string convertFromString<std::string>(StringView text) {return std::string(text);}
template<>
const char * convertFromString<const char *>(StringView text) {return text.data();}
template<>
int convertFromString<int>(StringView text) {return std::stoi(std::string(text));}
template<>
unsigned convertFromString<unsigned>(StringView text) {return static_cast<unsigned>(std::stoul(std::string(text)));}
template<>
long convertFromString<long>(StringView text) {return std::stol(std::string(text));}  // NOLINT
template<>
unsigned long convertFromString<unsigned long>(StringView text) {return std::stoul(std::string(text));}  // NOLINT
template<>
float convertFromString<float>(StringView text) {return std::stof(std::string(text));}
template<>
double convertFromString<double>(StringView text) {return std::stod(std::string(text));}
template<>
std::vector<int> convertFromString<std::vector<int>>(StringView text) {return numbers<int>(text);}
template<>
std::vector<double> convertFromString<std::vector<double>>(StringView text) {return numbers<double>(text);}
template<>
bool convertFromString<bool>(StringView text)
{
  if (text == "1" || text == "true" || text == "True" || text == "TRUE") {
    return true;
  }
  if (text == "0" || text == "false" || text == "False" || text == "FALSE") {
    return false;
  }
  throw RuntimeError("convertFromString(): invalid bool conversion");
}
template<>
NodeStatus convertFromString<NodeStatus>(StringView text) {return read(STATUSES, text, "NodeStatus");}
template<>
NodeType convertFromString<NodeType>(StringView text) {return read(TYPES, text, "NodeType");}
template<>
PortDirection convertFromString<PortDirection>(StringView text)
{
  constexpr std::array<Name<PortDirection>, 3> capitals{{
    {PortDirection::INPUT, "INPUT"}, {PortDirection::OUTPUT, "OUTPUT"}, {PortDirection::INOUT, "INOUT"}}};
  for (auto & one : capitals) {
    if (text == one.text) {
      return one.value;
    }
  }
  return read(DIRECTIONS, text, "PortDirection");
}

std::string toStr(std::string value) {return value;}
template<>
std::string toStr<NodeStatus>(NodeStatus status) {return named(STATUSES, status).text;}
template<>
std::string toStr<NodeType>(NodeType type) {return named(TYPES, type).text;}
template<>
std::string toStr<PortDirection>(PortDirection direction) {return named(DIRECTIONS, direction).text;}
std::string toStr(NodeStatus status, bool colored)
{
  const auto & name = named(STATUSES, status);
  return colored ? StrCat(name.color, name.text, "\x1b[0m") : std::string(name.text);
}
std::ostream & operator<<(std::ostream & to, const NodeStatus & status) {return to << toStr(status);}
std::ostream & operator<<(std::ostream & to, const NodeType & type) {return to << toStr(type);}
std::ostream & operator<<(std::ostream & to, const PortDirection & direction) {return to << toStr(direction);}

std::vector<StringView> splitString(const StringView & text, char delimiter)
{
  std::vector<StringView> parts;
  for (size_t begin = 0; begin < text.size(); ) {
    const size_t end = std::min(text.find(delimiter, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}
bool IsReservedPortname(StringView name) {return name == "ID" || name == "name" || name == "_description";}

Any PortInfo::parse(StringView text) const
{
  try {
    return converter_ ? converter_(text) : Any();
  } catch (const std::exception &) {
    return {};
  }
}
}  // namespace BT
