// A callback that is registered; it is called until this is disconnected.
#pragma once
#include <functional>
#include <utility>

namespace message_filters
{
class Connection
{
public:
  Connection() = default;
  explicit Connection(std::function<void ()> disconnect)
  : disconnect_(std::move(disconnect)) {}
  void disconnect()
  {
    if (auto now = std::move(disconnect_)) {
      disconnect_ = nullptr;
      now();
    }
  }

private:
  std::function<void ()> disconnect_;
};
}  // namespace message_filters
