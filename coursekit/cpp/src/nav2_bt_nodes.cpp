// Nodes of bt_navigator's trees that are C++ classes of libraries: it ticks its tree, and has these ticked here.
#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "behaviortree_cpp_v3/bt_factory.h"
#include "coursekit/nav2.hpp"
#include "coursekit/plugins.hpp"
#include "nav2_bt_values.hpp"
#include "nav2_util/odometry_utils.hpp"
#include "rclcpp/copy_all_parameter_values.hpp"

namespace BT
{
using coursekit::Packer;
using coursekit::Unpacker;

namespace
{
/// Stands for a child that the navigator has; `of` and `place` say which.
class Child : public ActionNodeBase
{
public:
  using ActionNodeBase::ActionNodeBase;
  static PortsList providedPorts() {return {InputPort<int>("of"), InputPort<int>("place")};}
  void halt() override
  {
    if (status() != NodeStatus::IDLE) {
      navigators("halt");
      resetStatus();
    }
  }

private:
  NodeStatus tick() override {return static_cast<NodeStatus>(navigators(status() == NodeStatus::IDLE ? "begin" : "tick").i());}
  Unpacker navigators(const char * what) const
  {
    return coursekit::request("tree_child", Packer{}.i(*getInput<int>("of")).i(*getInput<int>("place")).s(what));
  }
};
}  // namespace

/// A tree of one node and stands for its children.
struct ServedNode
{
  Tree tree;
  TreeNode & node() {return *tree.rootNode();}
  void rest() {node().resetStatus();}
};

namespace
{
struct TreeHost : coursekit::Nav2Server
{
  explicit TreeHost(std::string paths_)
  : paths(std::move(paths_))
  {
    factory.registerNodeType<Child>("NavigatorsChild");
  }
  void load()
  {
    for (auto & path : splitString(paths, '\n')) {
      factory.registerFromPlugin(std::string(path));
    }
  }
  void configure(Unpacker & from)
  {
    meet_node(from);
    const std::vector<std::string> own{"--ros-args", "-r", "__node:=" + name, "--"};  // not the navigator's, which is remapped
    client = std::make_shared<rclcpp::Node>("_", rclcpp::NodeOptions().arguments(own));
    rclcpp::copy_all_parameter_values(node, client);
    loop = std::chrono::milliseconds(from.i());
    timeout = std::chrono::milliseconds(from.i());
    odometry = std::make_shared<nav2_util::OdomSmoother>(node, 0.3, from.s());
  }
  Blackboard & board(int64_t number)
  {
    auto & kept = boards[number];
    if (!kept) {
      kept = Blackboard::create();
      kept->set("node", client);
      kept->set("tf_buffer", buffer);
      kept->set("odom_smoother", odometry);
      kept->set("bt_loop_duration", loop);
      kept->set("server_timeout", timeout);
      kept->set("initial_pose_received", true);
      kept->set("number_recoveries", 0);
      kept->take_changed();
    }
    return *kept;
  }
  std::vector<std::string> kinds() const
  {
    std::vector<std::string> all;
    for (auto & manifest : factory.manifests()) {
      if (!factory.builtinNodes().count(manifest.first) && manifest.first != "NavigatorsChild") {
        all.push_back(manifest.first);
      }
    }
    return all;
  }

  std::string paths;
  BehaviorTreeFactory factory;
  rclcpp::Node::SharedPtr client;
  std::chrono::milliseconds loop{}, timeout{};
  std::shared_ptr<nav2_util::OdomSmoother> odometry;
  std::map<int64_t, Blackboard::Ptr> boards;
  std::map<int64_t, ServedNode> nodes;
};

void take_news(Blackboard & board, Unpacker & from)
{
  for (int64_t count = from.i(); count > 0; --count) {
    const std::string key = from.s(), type = from.s();
    put(board, key, type, from.s());
  }
  board.take_changed();
}
void tell_news(Blackboard & board, Packer & to)
{
  for (const std::string & key : board.take_changed()) {
    const Any * value = board.getAny(key);
    const auto told = value && !value->empty() ? packed(*value) : std::pair<std::string, std::string>();
    if (!told.first.empty()) {
      to.s(key).s(told.first).s(told.second);
    }
  }
}
/// What is asked of one node: of which board, what has changed there, which node.
void serve_node(TreeHost & host, const std::string & what, Unpacker & from, Packer & done)
{
  const int64_t number = from.i();
  Blackboard & board = host.board(number);
  take_news(board, from);
  const int64_t which = from.i();
  if (what == "create") {
    host.nodes.emplace(which, ServedNode{host.factory.createTreeFromText(from.s(), host.boards[number])});
  } else if (what == "tick") {
    done.i(static_cast<int64_t>(host.nodes.at(which).node().executeTick()));
  } else if (what == "halt") {
    host.nodes.at(which).node().halt();
    host.nodes.at(which).rest();
  } else {
    host.nodes.at(which).rest();
  }
  tell_news(board, done);
}
void serve(TreeHost & host, Unpacker & from, Packer & done)
{
  const std::string what = from.s();
  if (what == "make") {
    host.load();
  } else if (what == "configure") {
    host.configure(from);
  } else if (what == "kinds") {
    for (const std::string & kind : host.kinds()) {
      done.s(kind);
    }
  } else if (what == "forget") {
    host.nodes.erase(from.i());
  } else if (what == "forget_board") {
    host.boards.erase(from.i());
  } else if (what == "empty_board") {
    host.boards[from.i()] = Blackboard::create();
  } else {
    serve_node(host, what, from, done);
  }
}
}  // namespace
}  // namespace BT

coursekit::Handler coursekit::tree_nodes_of(const std::string & paths)
{
  auto host = std::make_shared<BT::TreeHost>(paths);
  return [host](Unpacker & from, Packer & to) {careful(to, [&](Packer & done) {BT::serve(*host, from, done);});};
}
