// Reads descriptions of trees, and checks them before anything is made of them.
#include "bt_description.hpp"

#include <fstream>
#include <iterator>

#include "behaviortree_cpp_v3/xml_parsing.h"

namespace BT
{
namespace description
{
void fail(const Element & at, const std::string & why)
{
  throw RuntimeError("Error at line ", std::to_string(at.line), ": -> ", why);
}
Element read(const std::string & text)
{
  try {
    return coursekit::xml::read(text);
  } catch (const coursekit::xml::Error & error) {
    throw RuntimeError("Error parsing the XML: ", error.what());
  }
}
Element read_file(const std::filesystem::path & path)
{
  std::ifstream file(path, std::ios::binary);
  if (!file || !std::filesystem::is_regular_file(path)) {
    throw RuntimeError("Error parsing the XML: XML_ERROR_FILE_NOT_FOUND: ", path.string());
  }
  try {
    return read({std::istreambuf_iterator<char>(file), {}});
  } catch (const RuntimeError & error) {
    throw RuntimeError(error.what(), " (", path.string(), ")");
  }
}
bool is_explicit(const std::string & name)
{
  return name == "Action" || name == "Condition" || name == "Control" || name == "Decorator";
}
namespace
{
void verify_count(const Element & element, NodeType type)
{
  const size_t count = element.children.size();
  const std::string node = "The node <" + element.name + "> must ";
  if (type == NodeType::DECORATOR && count != 1) {
    fail(element, node + "have exactly 1 child");
  }
  if (is_explicit(element.name) && type == NodeType::CONTROL && count == 0) {
    fail(element, node + "have at least 1 child");
  }
  if (is_explicit(element.name) && (type == NodeType::ACTION || type == NodeType::CONDITION) && count != 0) {
    fail(element, node + "not have any child");
  }
}
void verify_node(const Element & element, const Types & types)
{
  const std::string & name = element.name;
  if ((is_explicit(name) || name == "SubTree") && !element.attribute("ID")) {
    fail(element, "The node <" + name + "> must have the attribute [ID]");
  }
  if (name == "SubTree" && !element.children.empty()) {
    const bool remaps = element.children.front().name == "remap";
    fail(element, remaps ? "<remap> was deprecated" : "<SubTree> should not have any child");
  }
  if (is_explicit(name)) {
    verify_count(element, convertFromString<NodeType>(name));
  } else if (name == "Sequence" || name == "SequenceStar" || name == "Fallback") {
    if (element.children.empty()) {
      fail(element, "A Control node must have at least 1 child");
    }
  } else if (name != "SubTree") {
    auto found = types.find(name);
    if (found == types.end()) {
      fail(element, "Node not recognized: " + name);
    }
    verify_count(element, found->second);
  }
  for (const Element & child : element.children) {
    verify_node(child, types);
  }
}
}  // namespace

void verify(const Element & root, const Types & types)
{
  if (root.name != "root") {
    throw RuntimeError("The XML must have a root node called <root>");
  }
  size_t models = 0;
  for (const Element & child : root.children) {
    models += child.name == "TreeNodesModel";
    if (child.name == "TreeNodesModel" && models > 1) {
      fail(child, " Only a single node <TreeNodesModel> is supported");
    }
    if (child.name == "BehaviorTree") {
      if (child.children.size() != 1) {
        fail(child, "The node <BehaviorTree> must have exactly 1 child");
      }
      verify_node(child.children.front(), types);
    }
  }
}
}  // namespace description

void VerifyXML(const std::string & xml_text, const std::unordered_map<std::string, NodeType> & registered_nodes)
{
  description::verify(description::read(xml_text), registered_nodes);
}
}  // namespace BT
