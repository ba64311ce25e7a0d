// Hardware that only has states.
#pragma once
#include "hardware_interface/coursekit_component.hpp"

namespace hardware_interface
{
class SensorInterface : public HardwareComponent {};
}  // namespace hardware_interface
