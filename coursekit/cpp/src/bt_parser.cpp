// Trees from their descriptions in XML.
#include <set>

#include "behaviortree_cpp_v3/xml_parsing.h"
#include "bt_documents.hpp"

namespace BT
{
namespace
{
using description::Element;
using description::fail;
using description::is_explicit;

/// The keys that the ports of a tree's nodes are remapped to.
void collect_keys(const Element & element, std::set<std::string> & keys)
{
  for (auto & attribute : element.attributes) {
    if (!IsReservedPortname(attribute.first) && TreeNode::isBlackboardPointer(attribute.second)) {
      keys.emplace(TreeNode::stripBlackboardPointer(attribute.second));
    }
  }
  for (const Element & child : element.children) {
    collect_keys(child, keys);
  }
}
}  // namespace

struct XMLParser::Pimpl
{
  explicit Pimpl(const BehaviorTreeFactory & factory)
  : factory(factory), documents(factory) {}

  const BehaviorTreeFactory & factory;
  description::Documents documents;
  std::set<std::string> open;  // the trees that a subtree being made is in

  void declare_ports(const Element & element, const TreeNodeManifest & manifest, Blackboard & blackboard) const;
  NodeConfiguration configured(
    const Element & element, const TreeNodeManifest & manifest, const Blackboard::Ptr & blackboard) const;
  TreeNode::Ptr make_node(const Element & element, const Blackboard::Ptr & blackboard) const;
  void add_tree(const std::string & id, Tree & tree, const Blackboard::Ptr & blackboard, TreeNode * parent);
  void add_node(const Element & element, Tree & tree, const Blackboard::Ptr & blackboard, TreeNode * parent);
  Blackboard::Ptr blackboard_of_subtree(const Element & element, Tree & tree, const Blackboard::Ptr & outer) const;
  void remap_plus(const Element & element, Blackboard & inner) const;
};

void XMLParser::Pimpl::declare_ports(
  const Element & element, const TreeNodeManifest & manifest, Blackboard & blackboard) const
{
  for (auto & attribute : element.attributes) {
    auto port = manifest.ports.find(attribute.first);
    const auto pointed = TreeNode::getRemappedKey(attribute.first, attribute.second);
    if (port == manifest.ports.end() || !pointed) {
      continue;
    }
    const std::string key(*pointed);
    const PortInfo * before = blackboard.portInfo(key);
    const std::type_info * type = port->second.type();
    if (!before) {
      blackboard.setPortInfo(key, port->second);
    } else if (before->type() && type && *before->type() != *type) {
      blackboard.debugMessage();
      throw RuntimeError(
              "The creation of the tree failed because the port [", key, "] was initially created with type [",
              demangle(before->type()), "] and, later type [", demangle(type), "] was used somewhere else.");
    }
  }
}
NodeConfiguration XMLParser::Pimpl::configured(
  const Element & element, const TreeNodeManifest & manifest, const Blackboard::Ptr & blackboard) const
{
  NodeConfiguration config;
  config.blackboard = blackboard;
  for (auto & port : manifest.ports) {
    const std::string * given = element.attribute(port.first);
    const PortDirection direction = port.second.direction();
    const std::string & otherwise = port.second.defaultValue();
    if (direction != PortDirection::OUTPUT && (given || !otherwise.empty())) {
      config.input_ports.emplace(port.first, given ? *given : otherwise);
    }
    if (direction != PortDirection::INPUT && given) {
      config.output_ports.emplace(port.first, *given);
    }
  }
  return config;
}
TreeNode::Ptr XMLParser::Pimpl::make_node(const Element & element, const Blackboard::Ptr & blackboard) const
{
  const std::string id = is_explicit(element.name) ? *element.attribute("ID") : element.name;
  const bool subtree = id == "SubTree" || id == "SubTreePlus";
  const std::string * named = element.attribute(subtree ? "ID" : "name");
  if (subtree && !named) {
    fail(element, "The node <" + id + "> must have the attribute [ID]");
  }
  const std::string name = named ? *named : id;
  auto found = factory.manifests().find(id);
  if (found == factory.manifests().end()) {
    throw RuntimeError(id, " is not a registered node, nor a Subtree");
  }
  if (subtree) {
    return factory.instantiateTreeNode(name, id, configured({}, {}, blackboard));
  }
  const TreeNodeManifest & manifest = found->second;
  for (auto & attribute : element.attributes) {
    if (!IsReservedPortname(attribute.first) && !manifest.ports.count(attribute.first)) {
      throw RuntimeError(
              "Possible typo? In the XML, you tried to remap port \"", attribute.first, "\" in node [", id, " / ", name,
              "], but the manifest of this node does not contain a port with this name.");
    }
  }
  declare_ports(element, manifest, *blackboard);
  return factory.instantiateTreeNode(name, id, configured(element, manifest, blackboard));
}

void XMLParser::Pimpl::add_tree(
  const std::string & id, Tree & tree, const Blackboard::Ptr & blackboard, TreeNode * parent)
{
  if (!open.insert(id).second) {
    throw RuntimeError("The tree [", id, "] contains itself as a subtree");
  }
  add_node(documents.root_of(id), tree, blackboard, parent);
  open.erase(id);
}
void XMLParser::Pimpl::add_node(
  const Element & element, Tree & tree, const Blackboard::Ptr & blackboard, TreeNode * parent)
{
  const TreeNode::Ptr node = make_node(element, blackboard);
  tree.nodes.push_back(node);
  if (auto control = dynamic_cast<ControlNode *>(parent)) {
    control->addChild(node.get());
  } else if (auto decorator = dynamic_cast<DecoratorNode *>(parent)) {
    decorator->setChild(node.get());
  }
  if (node->type() == NodeType::SUBTREE) {
    return add_tree(node->name(), tree, blackboard_of_subtree(element, tree, blackboard), node.get());
  }
  for (const Element & child : element.children) {
    add_node(child, tree, blackboard, node.get());
  }
}
Blackboard::Ptr XMLParser::Pimpl::blackboard_of_subtree(
  const Element & element, Tree & tree, const Blackboard::Ptr & outer) const
{
  const std::string * shared = element.attribute("__shared_blackboard");
  const bool plus = element.name == "SubTreePlus";
  if (!plus && shared && convertFromString<bool>(*shared)) {
    return outer;
  }
  auto inner = Blackboard::create(outer);
  tree.blackboard_stack.push_back(inner);
  if (plus) {
    remap_plus(element, *inner);
    return inner;
  }
  for (auto & attribute : element.attributes) {
    if (!IsReservedPortname(attribute.first)) {
      inner->addSubtreeRemapping(attribute.first, attribute.second);
    }
  }
  return inner;
}
void XMLParser::Pimpl::remap_plus(const Element & element, Blackboard & inner) const
{
  std::set<std::string> keys, mapped;
  for (auto & attribute : element.attributes) {
    if (attribute.first == "__autoremap") {
      if (convertFromString<bool>(attribute.second)) {
        collect_keys(documents.root_of(*element.attribute("ID")), keys);
      }
    } else if (!IsReservedPortname(attribute.first)) {
      mapped.insert(attribute.first);
      if (TreeNode::isBlackboardPointer(attribute.second)) {
        inner.addSubtreeRemapping(attribute.first, TreeNode::stripBlackboardPointer(attribute.second));
      } else {
        inner.set(attribute.first, attribute.second);
      }
    }
  }
  for (auto & key : keys) {
    if (!mapped.count(key)) {
      inner.addSubtreeRemapping(key, key);
    }
  }
}

XMLParser::XMLParser(const BehaviorTreeFactory & factory)
: _p(std::make_unique<Pimpl>(factory)) {}
XMLParser::~XMLParser() = default;

void XMLParser::loadFromFile(const std::string & filename, bool add_includes)
{
  _p->documents.load_file(filename, add_includes);
}
void XMLParser::loadFromText(const std::string & xml_text, bool add_includes)
{
  _p->documents.load(description::read(xml_text), add_includes);
}
std::vector<std::string> XMLParser::registeredBehaviorTrees() const
{
  std::vector<std::string> names;
  for (auto & tree : _p->documents.trees()) {
    names.push_back(tree.first);
  }
  return names;
}
Tree XMLParser::instantiateTree(const Blackboard::Ptr & root_blackboard, std::string main_tree_to_execute)
{
  const std::string name = main_tree_to_execute.empty() ? _p->documents.main_tree() : main_tree_to_execute;
  if (!root_blackboard) {
    throw RuntimeError("XMLParser::instantiateTree needs a non-empty root_blackboard");
  }
  Tree tree;
  tree.blackboard_stack.push_back(root_blackboard);
  _p->open.clear();
  try {
    _p->add_tree(name, tree, root_blackboard, nullptr);
  } catch (...) {
    tree.nodes.clear();  // half a tree cannot be halted
    throw;
  }
  tree.initialize();
  return tree;
}
void XMLParser::clearInternalState()
{
  const BehaviorTreeFactory & factory = _p->factory;
  _p = std::make_unique<Pimpl>(factory);
}

Tree buildTreeFromText(const BehaviorTreeFactory & factory, const std::string & text, const Blackboard::Ptr & blackboard)
{
  XMLParser parser(factory);
  parser.loadFromText(text);
  return parser.instantiateTree(blackboard);
}
Tree buildTreeFromFile(
  const BehaviorTreeFactory & factory, const std::string & filename, const Blackboard::Ptr & blackboard)
{
  XMLParser parser(factory);
  parser.loadFromFile(filename);
  return parser.instantiateTree(blackboard);
}
}  // namespace BT
