// Of an event about parameters, what is about some names, and of some kinds.
#pragma once
#include <algorithm>
#include <utility>

#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{
class ParameterEventsFilter
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterEventsFilter)
  enum class EventType {NEW, DELETED, CHANGED};
  using EventPair = std::pair<EventType, const rcl_interfaces::msg::Parameter *>;

  /// The filter keeps the event: its parameters are pointed to.
  ParameterEventsFilter(
    std::shared_ptr<const rcl_interfaces::msg::ParameterEvent> event, const std::vector<std::string> & names,
    const std::vector<EventType> & types)
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
  const std::vector<EventPair> & get_events() const {return found_;}

private:
  std::shared_ptr<const rcl_interfaces::msg::ParameterEvent> event_;
  std::vector<EventPair> found_;
};
}  // namespace rclcpp
