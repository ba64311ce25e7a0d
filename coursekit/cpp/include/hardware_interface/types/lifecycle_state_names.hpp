// The names of the states of hardware.
#pragma once

namespace hardware_interface::lifecycle_state_names
{
constexpr char UNKNOWN[] = "unknown";
constexpr char UNCONFIGURED[] = "unconfigured";
constexpr char INACTIVE[] = "inactive";
constexpr char ACTIVE[] = "active";
constexpr char FINALIZED[] = "finalized";
}  // namespace hardware_interface::lifecycle_state_names
