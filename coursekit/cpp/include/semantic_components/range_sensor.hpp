// The state of a range finder.
#pragma once
#include <string>

#include "semantic_components/semantic_component_interface.hpp"
#include "sensor_msgs/msg/range.hpp"

namespace semantic_components
{
class RangeSensor : public SemanticComponentInterface<sensor_msgs::msg::Range>
{
public:
  explicit RangeSensor(const std::string & name)
  : SemanticComponentInterface(name, 1)
  {
    interface_names_.push_back(name_ + "/range");
  }
  float get_range() const {return static_cast<float>(state_interfaces_.at(0).get().get_value());}
  /// Only the distance [m] is written; what the sensor is like is left as it is.
  bool get_values_as_message(sensor_msgs::msg::Range & message)
  {
    message.range = get_range();
    return true;
  }
};
}  // namespace semantic_components
