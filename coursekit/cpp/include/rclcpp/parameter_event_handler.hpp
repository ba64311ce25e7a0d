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
    subscription_ = node_of(node).template create_subscription<Event>("/parameter_events", qos, [this](const Event & e) {hear(e);});
  }
  /// Call back when that parameter changes, of this node where none is named; until the handle is gone.
  ParameterCallbackHandle::SharedPtr add_parameter_callback(
    const std::string & name, ParameterCallbackType callback, const std::string & node_name = "")
  {
    auto handle = std::make_shared<ParameterCallbackHandle>();
    handle->parameter_name = name;
    handle->node_name = full_name(node_name);
    handle->callback = std::move(callback);
    of_parameters_.push_front(handle);
    return handle;
  }
  void remove_parameter_callback(ParameterCallbackHandle::SharedPtr handle) {remove(of_parameters_, handle);}
  ParameterEventCallbackHandle::SharedPtr add_parameter_event_callback(ParameterEventCallbackType callback)
  {
    auto handle = std::make_shared<ParameterEventCallbackHandle>();
    handle->callback = std::move(callback);
    of_events_.push_front(handle);
    return handle;
  }
  void remove_parameter_event_callback(ParameterEventCallbackHandle::SharedPtr handle) {remove(of_events_, handle);}

  static bool get_parameter_from_event(
    const Event & event, Parameter & parameter, const std::string & name, const std::string & node_name = "")
  {
    if (!node_name.empty() && event.node != node_name) {
      return false;
    }
    for (auto & found : get_parameters_from_event(event)) {
      if (found.get_name() == name) {
        parameter = found;
        return true;
      }
    }
    return false;
  }
  static Parameter get_parameter_from_event(const Event & event, const std::string & name, const std::string & node_name = "")
  {
    Parameter parameter;
    if (!get_parameter_from_event(event, parameter, name, node_name)) {
      throw std::runtime_error("Parameter '" + name + "' of node '" + node_name + "' is not part of parameter event");
    }
    return parameter;
  }
  static std::vector<Parameter> get_parameters_from_event(const Event & event)
  {
    std::vector<Parameter> all;
    for (auto * part : {&event.new_parameters, &event.changed_parameters}) {
      for (auto & message : *part) {
        all.push_back(Parameter::from_parameter_msg(message));
      }
    }
    return all;
  }

private:
  template<class H>
  using Handles = std::list<std::weak_ptr<H>>;
  template<class H>
  void remove(Handles<H> & handles, const std::shared_ptr<H> & handle)
  {
    size_t before = handles.size();
    handles.remove_if([&](auto & weak) {return weak.lock() == handle;});
    if (handles.size() == before) {
      throw std::runtime_error("Callback doesn't exist");
    }
  }
  void hear(const Event & event)
  {
    auto told = of_parameters_;  // a callback may remove itself
    for (auto & weak : told) {
      auto handle = weak.lock();
      Parameter parameter;
      if (handle && get_parameter_from_event(event, parameter, handle->parameter_name, handle->node_name)) {
        handle->callback(parameter);
      }
    }
    auto whole = of_events_;
    for (auto & weak : whole) {
      if (auto handle = weak.lock()) {
        handle->callback(event);
      }
    }
  }
  std::string full_name(const std::string & name) const
  {
    if (name.empty()) {
      return base_->full_name;
    }
    return name[0] == '/' ? name : base_->space + (base_->space == "/" ? "" : "/") + name;
  }
  node_interfaces::NodeBaseInterface::SharedPtr base_;
  Subscription<Event>::SharedPtr subscription_;
  Handles<ParameterCallbackHandle> of_parameters_;
  Handles<ParameterEventCallbackHandle> of_events_;
};
}  // namespace rclcpp
