// Who watches the graph for nodes: here the session does, so this only remembers for whom.
#pragma once
#include <algorithm>
#include <mutex>
#include <vector>

#include "rclcpp/node_interfaces/node_base_interface.hpp"

namespace rclcpp::graph_listener
{
class GraphListenerShutdownError : public std::runtime_error
{
public:
  GraphListenerShutdownError()
  : std::runtime_error("GraphListener already shutdown") {}
};
class NodeAlreadyAddedError : public std::runtime_error
{
public:
  NodeAlreadyAddedError()
  : std::runtime_error("node already added") {}
};
class NodeNotFoundError : public std::runtime_error
{
public:
  NodeNotFoundError()
  : std::runtime_error("node not found") {}
};

class GraphListener : public std::enable_shared_from_this<GraphListener>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GraphListener)
  using Node = node_interfaces::NodeGraphInterface;
  explicit GraphListener(const std::shared_ptr<Context> &) {}
  virtual ~GraphListener() = default;
  virtual void start_if_not_started()
  {
    std::lock_guard<std::mutex> hold(lock_);
    refuse_after_shutdown();
    started_ = true;
  }
  virtual void add_node(Node * node)
  {
    std::lock_guard<std::mutex> hold(lock_);
    if (!node) {
      throw std::invalid_argument("node is nullptr");
    }
    refuse_after_shutdown();
    if (known(node)) {
      throw NodeAlreadyAddedError();
    }
    nodes_.push_back(node);
  }
  virtual bool has_node(Node * node)
  {
    std::lock_guard<std::mutex> hold(lock_);
    return known(node);
  }
  virtual void remove_node(Node * node)
  {
    std::lock_guard<std::mutex> hold(lock_);
    if (!node) {
      throw std::invalid_argument("node is nullptr");
    }
    if (!known(node)) {
      throw NodeNotFoundError();
    }
    nodes_.erase(std::find(nodes_.begin(), nodes_.end(), node));
  }
  virtual void shutdown()
  {
    std::lock_guard<std::mutex> hold(lock_);
    shut_down_ = true;
    started_ = false;
  }
  virtual bool is_started() {return started_;}
  virtual bool is_shutdown() {return shut_down_;}

private:
  bool known(Node * node) const {return node && std::find(nodes_.begin(), nodes_.end(), node) != nodes_.end();}
  void refuse_after_shutdown() const
  {
    if (shut_down_) {
      throw GraphListenerShutdownError();
    }
  }
  std::mutex lock_;
  std::vector<Node *> nodes_;
  std::atomic<bool> started_{false}, shut_down_{false};
};
}  // namespace rclcpp::graph_listener
