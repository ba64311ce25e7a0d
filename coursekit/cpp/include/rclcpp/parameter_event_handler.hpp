// Callbacks for changes of parameters, of any node.
#pragma once
#include <list>

#include "rclcpp/parameter_client.hpp"

namespace rclcpp
{
struct ParameterCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterCallbackHandle)
  using ParameterCallbackType = std::function<void (const Parameter &)>;
  std::string parameter_name, node_name;
  ParameterCallbackType callback;
};
struct ParameterEventCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterEventCallbackHandle)
  using ParameterEventCallbackType = std::function<void (const rcl_interfaces::msg::ParameterEvent &)>;
  ParameterEventCallbackType callback;
};

class ParameterEventHandler
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterEventHandler)
  using Event = rcl_interfaces::msg::ParameterEvent;
  using ParameterCallbackType = ParameterCallbackHandle::ParameterCallbackType;
  using ParameterEventCallbackType = ParameterEventCallbackHandle::ParameterEventCallbackType;

  template<class N>
  explicit ParameterEventHandler(N && node, const QoS & qos = QoS(KeepAll()).reliable())
  : base_(base_of(node))
  {
    subscription_ = node_of(node).template create_subscription<Event>(
      "/parameter_events", qos, [this](const Event & event) {event_callback(event);});
  }
  /// Call back when that parameter changes, of this node where none is named; until the handle is gone.
  ParameterCallbackHandle::SharedPtr add_parameter_callback(
    const std::string & name, ParameterCallbackType callback, const std::string & node_name = "");
  void remove_parameter_callback(ParameterCallbackHandle::SharedPtr handle);
  ParameterEventCallbackHandle::SharedPtr add_parameter_event_callback(ParameterEventCallbackType callback);
  void remove_parameter_event_callback(ParameterEventCallbackHandle::SharedPtr handle);

  static bool get_parameter_from_event(
    const Event & event, Parameter & parameter, const std::string & name, const std::string & node_name = "");
  static Parameter get_parameter_from_event(const Event & event, const std::string & name, const std::string & node_name = "");
  static std::vector<Parameter> get_parameters_from_event(const Event & event);

protected:
  /// Call back those whom an event is about; the last that was added is called first.
  void event_callback(const Event & event);
  std::list<ParameterCallbackHandle::WeakPtr> parameter_callbacks_;
  std::list<ParameterEventCallbackHandle::WeakPtr> event_callbacks_;

private:
  std::string full_name(const std::string & name) const;

  node_interfaces::NodeBaseInterface::SharedPtr base_;
  Subscription<Event>::SharedPtr subscription_;
};
}  // namespace rclcpp
