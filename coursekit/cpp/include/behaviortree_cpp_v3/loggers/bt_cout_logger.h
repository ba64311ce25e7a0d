// Prints each change of a node's status.
#pragma once
#include <atomic>

#include "behaviortree_cpp_v3/loggers/abstract_logger.h"

namespace BT
{
class StdCoutLogger : public StatusChangeLogger
{
public:
  /// Throws LogicError while there is another one.
  explicit StdCoutLogger(const Tree & tree);
  ~StdCoutLogger() override;
  void callback(Duration timestamp, const TreeNode & node, NodeStatus prev_status, NodeStatus status) override;
  void flush() override;

private:
  static std::atomic<bool> taken_;
};
}  // namespace BT
