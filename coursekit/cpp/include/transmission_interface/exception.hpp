// What transmissions throw.
#pragma once
#include <stdexcept>

namespace transmission_interface
{
class TransmissionInterfaceException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
class Exception : public TransmissionInterfaceException
{
public:
  using TransmissionInterfaceException::TransmissionInterfaceException;
};
}  // namespace transmission_interface
