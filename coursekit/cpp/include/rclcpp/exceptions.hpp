// What rclcpp throws; the session's refusals become these.
#pragma once
#include <stdexcept>
#include <string>

#include "coursekit/link.hpp"

namespace rclcpp
{
namespace exceptions
{
#define COURSEKIT_ERROR(Name, Base) \
  class Name : public Base \
  { \
    using Parent = Base; \
public: \
    using Parent::Parent; \
  };
COURSEKIT_ERROR(RCLErrorBase, std::runtime_error)
class RCLError : public RCLErrorBase
{
public:
  explicit RCLError(const std::string & text)
  : RCLErrorBase(text), message(text), formatted_message(text) {}
  std::string message, formatted_message;
};
COURSEKIT_ERROR(RCLBadAlloc, std::runtime_error)
COURSEKIT_ERROR(RCLInvalidArgument, RCLError)
COURSEKIT_ERROR(RCLInvalidROSArgsError, RCLError)
COURSEKIT_ERROR(NameValidationError, std::invalid_argument)
COURSEKIT_ERROR(InvalidNodeNameError, NameValidationError)
COURSEKIT_ERROR(InvalidNamespaceError, NameValidationError)
COURSEKIT_ERROR(InvalidTopicNameError, NameValidationError)
COURSEKIT_ERROR(InvalidServiceNameError, NameValidationError)
COURSEKIT_ERROR(UnimplementedError, std::runtime_error)
COURSEKIT_ERROR(UnknownROSArgsError, std::runtime_error)
COURSEKIT_ERROR(UnsupportedEventTypeException, RCLErrorBase)
COURSEKIT_ERROR(InvalidEventError, std::runtime_error)
COURSEKIT_ERROR(InvalidParametersException, std::runtime_error)
COURSEKIT_ERROR(InvalidParameterValueException, std::runtime_error)
COURSEKIT_ERROR(InvalidParameterTypeException, std::runtime_error)
COURSEKIT_ERROR(ParameterAlreadyDeclaredException, std::runtime_error)
COURSEKIT_ERROR(ParameterNotDeclaredException, std::runtime_error)
COURSEKIT_ERROR(ParameterImmutableException, std::runtime_error)
COURSEKIT_ERROR(ParameterModifiedInCallbackException, std::runtime_error)
COURSEKIT_ERROR(ParameterUninitializedException, std::runtime_error)
COURSEKIT_ERROR(UninitializedStaticallyTypedParameterException, std::runtime_error)
COURSEKIT_ERROR(QoSCheckCompatibleException, std::runtime_error)
class EventNotRegisteredError : public std::runtime_error
{
public:
  EventNotRegisteredError()
  : std::runtime_error("event already registered") {}
};
}  // namespace exceptions
COURSEKIT_ERROR(ParameterTypeException, std::runtime_error)

using coursekit::Packer;
using coursekit::Unpacker;

/// Ask the session; a refusal is thrown as what rclcpp throws in that case.
Unpacker ask(const char * what, const Packer & with = {});
}  // namespace rclcpp
