// Places of numbers on both sides of a transmission.
#pragma once
#include "hardware_interface/handle.hpp"

namespace transmission_interface
{
class ActuatorHandle : public hardware_interface::ReadWriteHandle
{
public:
  using hardware_interface::ReadWriteHandle::ReadWriteHandle;
};
class JointHandle : public hardware_interface::ReadWriteHandle
{
public:
  using hardware_interface::ReadWriteHandle::ReadWriteHandle;
};
}  // namespace transmission_interface
