// Ticks all of its children until enough of them have succeeded or failed; negative thresholds count from all of them.
#pragma once
#include <set>
#include <string>

#include "behaviortree_cpp_v3/control_node.h"

namespace BT
{
class ParallelNode : public ControlNode
{
public:
  ParallelNode(const std::string & name, int success_threshold, int failure_threshold = 1);
  ParallelNode(const std::string & name, const NodeConfiguration & config)
  : ControlNode(name, config), read_ports_(true) {}
  static PortsList providedPorts();
  void halt() override;

  size_t successThreshold() const {return counted(success_threshold_);}
  size_t failureThreshold() const {return counted(failure_threshold_);}
  void setSuccessThreshold(int threshold) {success_threshold_ = threshold;}
  void setFailureThreshold(int threshold) {failure_threshold_ = threshold;}

private:
  NodeStatus tick() override;
  NodeStatus end(NodeStatus status);
  size_t counted(int threshold) const;
  void check_thresholds();

  int success_threshold_ = 1;
  int failure_threshold_ = 1;
  std::set<size_t> finished_;
  bool read_ports_ = false;
};
}  // namespace BT
