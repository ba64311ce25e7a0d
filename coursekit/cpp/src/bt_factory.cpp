// The nodes that trees are made of, by their names.
#include "behaviortree_cpp_v3/bt_factory.h"

#include "behaviortree_cpp_v3/utils/shared_library.h"
#include "behaviortree_cpp_v3/xml_parsing.h"
#include "xml.hpp"

namespace BT
{
BehaviorTreeFactory::BehaviorTreeFactory()
: parser_(std::make_shared<XMLParser>(*this))
{
  register_controls();
  register_decorators();
  register_leaves();
  for (auto & builder : builders_) {
    builtin_.insert(builder.first);
  }
}
void BehaviorTreeFactory::register_controls()
{
  registerNodeType<FallbackNode>("Fallback");
  registerNodeType<SequenceNode>("Sequence");
  registerNodeType<SequenceStarNode>("SequenceStar");
  registerNodeType<ParallelNode>("Parallel");
  registerNodeType<ReactiveSequence>("ReactiveSequence");
  registerNodeType<ReactiveFallback>("ReactiveFallback");
  registerNodeType<IfThenElseNode>("IfThenElse");
  registerNodeType<WhileDoElseNode>("WhileDoElse");
  registerNodeType<SwitchNode<2>>("Switch2");
  registerNodeType<SwitchNode<3>>("Switch3");
  registerNodeType<SwitchNode<4>>("Switch4");
  registerNodeType<SwitchNode<5>>("Switch5");
  registerNodeType<SwitchNode<6>>("Switch6");
}
void BehaviorTreeFactory::register_decorators()
{
  registerNodeType<InverterNode>("Inverter");
  registerNodeType<RetryNodeTypo>("RetryUntilSuccesful");
  registerNodeType<RetryNode>("RetryUntilSuccessful");
  registerNodeType<KeepRunningUntilFailureNode>("KeepRunningUntilFailure");
  registerNodeType<RepeatNode>("Repeat");
  registerNodeType<TimeoutNode<>>("Timeout");
  registerNodeType<DelayNode>("Delay");
  registerNodeType<ForceSuccessNode>("ForceSuccess");
  registerNodeType<ForceFailureNode>("ForceFailure");
  registerNodeType<SubtreeNode>("SubTree");
  registerNodeType<SubtreePlusNode>("SubTreePlus");
  registerNodeType<BlackboardPreconditionNode<int>>("BlackboardCheckInt");
  registerNodeType<BlackboardPreconditionNode<double>>("BlackboardCheckDouble");
  registerNodeType<BlackboardPreconditionNode<std::string>>("BlackboardCheckString");
  registerNodeType<BlackboardPreconditionNode<bool>>("BlackboardCheckBool");
}
void BehaviorTreeFactory::register_leaves()
{
  registerNodeType<AlwaysSuccessNode>("AlwaysSuccess");
  registerNodeType<AlwaysFailureNode>("AlwaysFailure");
  registerNodeType<SetBlackboard>("SetBlackboard");
}

bool BehaviorTreeFactory::unregisterBuilder(const std::string & ID)
{
  if (builtin_.count(ID)) {
    throw LogicError("You can not remove the builtin registration ID [", ID, "]");
  }
  manifests_.erase(ID);
  return builders_.erase(ID);
}
void BehaviorTreeFactory::registerBuilder(const TreeNodeManifest & manifest, const NodeBuilder & builder)
{
  if (!builders_.emplace(manifest.registration_ID, builder).second) {
    throw BehaviorTreeException("ID [", manifest.registration_ID, "] already registered");
  }
  manifests_.emplace(manifest.registration_ID, manifest);
}
void BehaviorTreeFactory::registerSimpleAction(
  const std::string & ID, const SimpleActionNode::TickFunctor & tick_functor, PortsList ports)
{
  registerBuilder(
    {NodeType::ACTION, ID, ports, {}}, [tick_functor](const std::string & name, const NodeConfiguration & config) {
      return std::make_unique<SimpleActionNode>(name, tick_functor, config);
    });
}
void BehaviorTreeFactory::registerSimpleCondition(
  const std::string & ID, const SimpleConditionNode::TickFunctor & tick_functor, PortsList ports)
{
  registerBuilder(
    {NodeType::CONDITION, ID, ports, {}}, [tick_functor](const std::string & name, const NodeConfiguration & config) {
      return std::make_unique<SimpleConditionNode>(name, tick_functor, config);
    });
}
void BehaviorTreeFactory::registerSimpleDecorator(
  const std::string & ID, const SimpleDecoratorNode::TickFunctor & tick_functor, PortsList ports)
{
  registerBuilder(
    {NodeType::DECORATOR, ID, ports, {}}, [tick_functor](const std::string & name, const NodeConfiguration & config) {
      return std::make_unique<SimpleDecoratorNode>(name, tick_functor, config);
    });
}
void BehaviorTreeFactory::registerFromPlugin(const std::string & file_path)
{
  SharedLibrary library(file_path);
  if (!library.hasSymbol(PLUGIN_SYMBOL)) {
    std::cout << "ERROR loading library [" << file_path << "]: can't find symbol [" << PLUGIN_SYMBOL << "]" << std::endl;
    return;
  }
  reinterpret_cast<void (*)(BehaviorTreeFactory &)>(library.getSymbol(PLUGIN_SYMBOL))(*this);
}
void BehaviorTreeFactory::registerFromROSPlugins()
{
  throw RuntimeError("registerFromROSPlugins() is for ROS 1 alone: use registerFromPlugin()");
}
void BehaviorTreeFactory::registerBehaviorTreeFromFile(const std::string & filename) {parser_->loadFromFile(filename);}
void BehaviorTreeFactory::registerBehaviorTreeFromText(const std::string & xml_text) {parser_->loadFromText(xml_text);}
std::vector<std::string> BehaviorTreeFactory::registeredBehaviorTrees() const {return parser_->registeredBehaviorTrees();}
void BehaviorTreeFactory::clearRegisteredBehaviorTrees() {parser_->clearInternalState();}

std::unique_ptr<TreeNode> BehaviorTreeFactory::instantiateTreeNode(
  const std::string & name, const std::string & ID, const NodeConfiguration & config) const
{
  auto found = builders_.find(ID);
  if (found == builders_.end()) {
    std::cerr << ID << " not included in this list:" << std::endl;
    for (auto & builder : builders_) {
      std::cerr << builder.first << std::endl;
    }
    throw RuntimeError("BehaviorTreeFactory: ID [", ID, "] not registered");
  }
  std::unique_ptr<TreeNode> node = found->second(name, config);
  node->setRegistrationID(ID);
  return node;
}
void BehaviorTreeFactory::addDescriptionToManifest(const std::string & node_id, const std::string & description)
{
  auto found = manifests_.find(node_id);
  if (found == manifests_.end()) {
    throw std::runtime_error("addDescriptionToManifest: wrong ID");
  }
  found->second.description = description;
}

Tree BehaviorTreeFactory::create(Parser & parser, Blackboard::Ptr blackboard, const std::string & name) const
{
  Tree tree = parser.instantiateTree(blackboard, name);
  tree.manifests = manifests_;
  return tree;
}
Tree BehaviorTreeFactory::createTreeFromText(const std::string & text, Blackboard::Ptr blackboard)
{
  XMLParser parser(*this);
  parser.loadFromText(text);
  return create(parser, blackboard, "");
}
Tree BehaviorTreeFactory::createTreeFromFile(const std::string & file_path, Blackboard::Ptr blackboard)
{
  XMLParser parser(*this);
  parser.loadFromFile(file_path);
  return create(parser, blackboard, "");
}
Tree BehaviorTreeFactory::createTree(const std::string & tree_name, Blackboard::Ptr blackboard)
{
  return create(*parser_, blackboard, tree_name);
}

namespace
{
std::string port_model(const std::string & name, const PortInfo & port)
{
  const std::string kind = port.direction() == PortDirection::INPUT ? "input_port" :
    port.direction() == PortDirection::OUTPUT ? "output_port" : "inout_port";
  std::string text = "<" + kind + " name=\"" + name + "\"";
  if (port.type()) {
    text += " type=\"" + coursekit::xml::escaped(demangle(port.type())) + "\"";
  }
  if (!port.defaultValue().empty()) {
    text += " default=\"" + coursekit::xml::escaped(port.defaultValue()) + "\"";
  }
  const std::string & description = port.description();
  return text + (description.empty() ? "/>" : ">" + coursekit::xml::escaped(description) + "</" + kind + ">");
}
std::string node_model(const TreeNodeManifest & manifest)
{
  std::set<std::pair<PortDirection, std::string>> ordered;
  for (auto & port : manifest.ports) {
    ordered.emplace(port.second.direction(), port.first);
  }
  const std::string type = toStr(manifest.type), indent(8, ' ');
  const std::string head = indent + "<" + type + " ID=\"" + manifest.registration_ID + "\"";
  if (ordered.empty()) {
    return head + "/>\n";
  }
  std::string text = head + ">\n";
  for (auto & one : ordered) {
    text += indent + "    " + port_model(one.second, manifest.ports.at(one.second)) + "\n";
  }
  return text + indent + "</" + type + ">\n";
}
}  // namespace

std::string writeTreeNodesModelXML(const BehaviorTreeFactory & factory, bool include_builtin)
{
  std::set<std::string> ordered;
  for (auto & manifest : factory.manifests()) {
    if (include_builtin || !factory.builtinNodes().count(manifest.first)) {
      ordered.insert(manifest.first);
    }
  }
  std::string nodes;
  for (auto & id : ordered) {
    nodes += node_model(factory.manifests().at(id));
  }
  const std::string models = nodes.empty() ? "    <TreeNodesModel/>\n" :
    "    <TreeNodesModel>\n" + nodes + "    </TreeNodesModel>\n";
  return "<root>\n" + models + "</root>\n";
}
}  // namespace BT
