// Changes of parameters: what of an event is about some names, and who is called back.
#include <algorithm>

#include "rclcpp/parameter_event_handler.hpp"
#include "rclcpp/parameter_events_filter.hpp"

namespace rclcpp
{
using rcl_interfaces::msg::ParameterEvent;

ParameterEventsFilter::ParameterEventsFilter(
  std::shared_ptr<const ParameterEvent> event, const std::vector<std::string> & names, const std::vector<EventType> & types)
: event_(std::move(event))
{
  auto take = [&](EventType type, const std::vector<rcl_interfaces::msg::Parameter> & parameters) {
      if (std::find(types.begin(), types.end(), type) == types.end()) {
        return;
      }
      for (auto & parameter : parameters) {
        if (std::find(names.begin(), names.end(), parameter.name) != names.end()) {
          found_.emplace_back(type, &parameter);
        }
      }
    };
  take(EventType::NEW, event_->new_parameters);
  take(EventType::CHANGED, event_->changed_parameters);
  take(EventType::DELETED, event_->deleted_parameters);
}

namespace
{
template<class H>
void remove_handle(std::list<std::weak_ptr<H>> & handles, const std::shared_ptr<H> & handle)
{
  const size_t before = handles.size();
  handles.remove_if([&](auto & weak) {return weak.lock() == handle;});
  if (handles.size() == before) {
    throw std::runtime_error("Callback doesn't exist");
  }
}
}  // namespace

ParameterCallbackHandle::SharedPtr ParameterEventHandler::add_parameter_callback(
  const std::string & name, ParameterCallbackType callback, const std::string & node_name)
{
  auto handle = std::make_shared<ParameterCallbackHandle>();
  handle->parameter_name = name;
  handle->node_name = full_name(node_name);
  handle->callback = std::move(callback);
  parameter_callbacks_.push_front(handle);
  return handle;
}
void ParameterEventHandler::remove_parameter_callback(ParameterCallbackHandle::SharedPtr handle)
{
  remove_handle(parameter_callbacks_, handle);
}
ParameterEventCallbackHandle::SharedPtr ParameterEventHandler::add_parameter_event_callback(ParameterEventCallbackType callback)
{
  auto handle = std::make_shared<ParameterEventCallbackHandle>();
  handle->callback = std::move(callback);
  event_callbacks_.push_front(handle);
  return handle;
}
void ParameterEventHandler::remove_parameter_event_callback(ParameterEventCallbackHandle::SharedPtr handle)
{
  remove_handle(event_callbacks_, handle);
}

bool ParameterEventHandler::get_parameter_from_event(
  const Event & event, Parameter & parameter, const std::string & name, const std::string & node_name)
{
  if (event.node != node_name) {
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
Parameter ParameterEventHandler::get_parameter_from_event(
  const Event & event, const std::string & name, const std::string & node_name)
{
  Parameter parameter;
  if (get_parameter_from_event(event, parameter, name, node_name)) {
    return parameter;
  }
  if (event.node == node_name) {
    return Parameter(name, PARAMETER_NOT_SET);
  }
  throw std::runtime_error(
          "The node name '" + node_name + "' of parameter '" + name + "' doesn't match the node name '" + event.node +
          "' in parameter event");
}
std::vector<Parameter> ParameterEventHandler::get_parameters_from_event(const Event & event)
{
  std::vector<Parameter> all;
  for (auto * part : {&event.new_parameters, &event.changed_parameters}) {
    for (auto & message : *part) {
      all.push_back(Parameter::from_parameter_msg(message));
    }
  }
  return all;
}

void ParameterEventHandler::event_callback(const Event & event)
{
  auto told = parameter_callbacks_;  // a callback may remove itself
  for (auto & weak : told) {
    auto handle = weak.lock();
    Parameter parameter;
    if (handle && get_parameter_from_event(event, parameter, handle->parameter_name, handle->node_name)) {
      handle->callback(parameter);
    }
  }
  auto whole = event_callbacks_;
  for (auto & weak : whole) {
    if (auto handle = weak.lock()) {
      handle->callback(event);
    }
  }
}
std::string ParameterEventHandler::full_name(const std::string & name) const
{
  if (name.empty()) {
    return base_->full_name;
  }
  return name[0] == '/' ? name : base_->space + (base_->space == "/" ? "" : "/") + name;
}
}  // namespace rclcpp
