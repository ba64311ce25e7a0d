// What rclcpp throws; the session's refusals become these.
#pragma once
#include <stdexcept>
#include <string>

#include "coursekit/link.hpp"
#include "rcl/error_handling.h"
#include "rcl/wait.h"

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
/// What the session refused; rcl would tell a place in its own source, too.
class RCLErrorBase : public std::runtime_error
{
public:
  explicit RCLErrorBase(const std::string & text, int ret_ = RCL_RET_ERROR)
  : std::runtime_error(text), ret(ret_), message(text), formatted_message(text) {}
  int ret;
  std::string message, file;
  size_t line = 0;
  std::string formatted_message;
};
COURSEKIT_ERROR(RCLError, RCLErrorBase)
COURSEKIT_ERROR(RCLBadAlloc, RCLErrorBase)
COURSEKIT_ERROR(RCLInvalidArgument, RCLError)
COURSEKIT_ERROR(RCLInvalidROSArgsError, RCLError)
/// A name that breaks the rules: which, why, and at which character.
class NameValidationError : public std::invalid_argument
{
public:
  NameValidationError(const char * name_type_, const char * name_, const char * error_msg_, size_t invalid_index_)
  : std::invalid_argument(format_error(name_type_, name_, error_msg_, invalid_index_)), name_type(name_type_),
    name(name_), error_msg(error_msg_), invalid_index(invalid_index_) {}
  static std::string format_error(const char * name_type, const char * name, const char * error_msg, size_t invalid_index)
  {
    const std::string place(invalid_index, ' ');
    return std::string("Invalid ") + name_type + ": " + error_msg + ":\n  '" + name + "'\n   " + place + "^\n";
  }
  const std::string name_type, name, error_msg;
  const size_t invalid_index;
};
#define COURSEKIT_NAME_ERROR(Name, type) \
  class Name : public NameValidationError \
  { \
public: \
    Name(const char * name, const char * error_msg, size_t invalid_index) \
    : NameValidationError(type, name, error_msg, invalid_index) {} \
  };
COURSEKIT_NAME_ERROR(InvalidNodeNameError, "node name")
COURSEKIT_NAME_ERROR(InvalidNamespaceError, "namespace")
COURSEKIT_NAME_ERROR(InvalidTopicNameError, "topic name")
COURSEKIT_NAME_ERROR(InvalidServiceNameError, "service name")
COURSEKIT_ERROR(UnimplementedError, std::runtime_error)
COURSEKIT_ERROR(UnknownROSArgsError, std::runtime_error)
COURSEKIT_ERROR(UnsupportedEventTypeException, RCLErrorBase)
#define COURSEKIT_ERROR_SAYING(Name, words) \
  class Name : public std::runtime_error \
  { \
public: \
    explicit Name(const std::string & text = words) \
    : std::runtime_error(text) {} \
  };
COURSEKIT_ERROR_SAYING(InvalidEventError, "event is invalid")
COURSEKIT_ERROR_SAYING(InvalidNodeError, "node is invalid")
COURSEKIT_ERROR(InvalidParametersException, std::runtime_error)
COURSEKIT_ERROR(InvalidParameterValueException, std::runtime_error)
class InvalidParameterTypeException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
  InvalidParameterTypeException(const std::string & name, const std::string & text)
  : std::runtime_error("parameter '" + name + "' has invalid type: " + text) {}
};
COURSEKIT_ERROR(ParameterAlreadyDeclaredException, std::runtime_error)
COURSEKIT_ERROR(ParameterNotDeclaredException, std::runtime_error)
COURSEKIT_ERROR(ParameterImmutableException, std::runtime_error)
COURSEKIT_ERROR(ParameterModifiedInCallbackException, std::runtime_error)
COURSEKIT_ERROR(ParameterUninitializedException, std::runtime_error)
COURSEKIT_ERROR(UninitializedStaticallyTypedParameterException, std::runtime_error)
COURSEKIT_ERROR(InvalidQosOverridesException, std::runtime_error)
COURSEKIT_ERROR(QoSCheckCompatibleException, std::runtime_error)
/// Throw what belongs to a return value of C's functions, with the last error there and what it is about.
[[noreturn]] void throw_from_rcl_error(
  int ret, const std::string & prefix = "", const rcl_error_state_t * error_state = nullptr,
  void (* reset_error)() = rcl_reset_error);
class EventNotRegisteredError : public std::runtime_error
{
public:
  EventNotRegisteredError()
  : std::runtime_error("event already registered") {}
};
}  // namespace exceptions

using coursekit::Packer;
using coursekit::Unpacker;

/// Ask the session; a refusal is thrown as what rclcpp throws in that case.
Unpacker ask(const char * what, const Packer & with = {});
}  // namespace rclcpp
