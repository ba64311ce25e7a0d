// Messages as bytes where their type is told by its support, and types that only their names tell.
#include <map>
#include <mutex>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp/typesupport_helpers.hpp"
#include "rcpputils/asserts.hpp"
#include "rmw/rmw.h"

namespace rclcpp
{
namespace
{
/// The type of a support; throws std::runtime_error where the program does not know what its messages have.
const coursekit::MessageType & known(const coursekit::MessageType & type)
{
  if (!type.to_bytes) {
    throw std::runtime_error(
            "this program knows " + type.name + " by its name only, so that its messages stay bytes: "
            "use rclcpp::Serialization with the message's class");
  }
  return type;
}
/// Whether the handle is of the support whose data are a coursekit::MessageType.
bool makes_bytes(const rosidl_message_type_support_t * type_support)
{
  return get_message_typesupport_handle_function(type_support, rosidl_typesupport_cpp::typesupport_identifier);
}
const coursekit::MessageType & type_of(const rosidl_message_type_support_t * type_support)
{
  rcpputils::check_true(type_support, "Typesupport is nullpointer.");
  if (!makes_bytes(type_support)) {
    throw std::runtime_error(std::string("no bytes are made by ") + type_support->typesupport_identifier);
  }
  return *static_cast<const coursekit::MessageType *>(type_support->data);
}
template<class T>
void need(const T * given, const char * what)
{
  rcpputils::check_true(given, std::string(what) + " is nullpointer.");
}
/// A type that the session knows, by its name; RCLError where it knows none.
const coursekit::MessageType & type_called(const std::string & name)
{
  static std::mutex lock;
  static auto * all = new std::map<std::string, coursekit::MessageType>;  // never destroyed: subscriptions may outlive it
  ask("type", Packer{}.s(name));
  std::lock_guard<std::mutex> hold(lock);
  return all->emplace(name, coursekit::MessageType{name}).first->second;
}
/// Refuse a support by which a program would look into messages.
void need_plain(const std::string & type, const std::string & identifier)
{
  if (identifier != rosidl_typesupport_cpp::typesupport_identifier) {
    throw std::runtime_error(
            "Typesupport library for " + type.substr(0, type.find('/')) + " does not exist: there is rosidl_typesupport_cpp, "
            "not " + identifier);
  }
}
}  // namespace

SerializationBase::SerializationBase(const rosidl_message_type_support_t * type_support)
: type_(type_of(type_support)) {}
void SerializationBase::serialize_message(const void * message, SerializedMessage * to) const
{
  need(message, "ROS message");
  need(to, "Serialized message");
  *to = SerializedMessage(known(type_).to_bytes(message));
}
void SerializationBase::deserialize_message(const SerializedMessage * from, void * message) const
{
  need(from, "Serialized message");
  rcpputils::check_true(from->capacity() != 0, "Wrongly initialized. Serialized message has a capacity of zero.");
  rcpputils::check_true(from->size() != 0, "Wrongly initialized. Serialized message has a size of zero.");
  need(message, "ROS message");
  known(type_).from_bytes(from->bytes(), message);
}

std::shared_ptr<rcpputils::SharedLibrary> get_typesupport_library(const std::string & type, const std::string & identifier)
{
  need_plain(type, identifier);
  type_called(type);
  return std::make_shared<rcpputils::SharedLibrary>();
}
const rosidl_message_type_support_t * detail::type_support_called(const std::string & type)
{
  static std::mutex lock;
  static auto * all = new std::map<std::string, rosidl_message_type_support_t>;
  const coursekit::MessageType & found = type_called(type);
  std::lock_guard<std::mutex> hold(lock);
  return &all->emplace(type, rosidl_message_type_support_t{rosidl_typesupport_cpp::typesupport_identifier, &found}).first->second;
}
const rosidl_message_type_support_t * get_typesupport_handle(
  const std::string & type, const std::string & identifier, rcpputils::SharedLibrary &)
{
  need_plain(type, identifier);
  return detail::type_support_called(type);
}
}  // namespace rclcpp

rmw_ret_t rmw_serialize(
  const void * message, const rosidl_message_type_support_t * type_support, rmw_serialized_message_t * serialized_message)
{
  if (!message || !type_support || !serialized_message) {
    return RMW_RET_INVALID_ARGUMENT;
  }
  auto type = static_cast<const coursekit::MessageType *>(type_support->data);
  if (!rclcpp::makes_bytes(type_support) || !type->to_bytes) {
    return RMW_RET_ERROR;
  }
  const std::string bytes = type->to_bytes(message);
  if (serialized_message->buffer_capacity < bytes.size()) {
    const rmw_ret_t grown = rmw_serialized_message_resize(serialized_message, bytes.size());
    if (grown != RMW_RET_OK) {
      return grown;
    }
  }
  memcpy(serialized_message->buffer, bytes.data(), bytes.size());
  serialized_message->buffer_length = bytes.size();
  return RMW_RET_OK;
}
rmw_ret_t rmw_deserialize(
  const rmw_serialized_message_t * serialized_message, const rosidl_message_type_support_t * type_support, void * message)
{
  if (!serialized_message || !type_support || !message) {
    return RMW_RET_INVALID_ARGUMENT;
  }
  auto type = static_cast<const coursekit::MessageType *>(type_support->data);
  if (!rclcpp::makes_bytes(type_support) || !type->from_bytes) {
    return RMW_RET_ERROR;
  }
  auto start = reinterpret_cast<const char *>(serialized_message->buffer);
  try {
    type->from_bytes(std::string(start, serialized_message->buffer_length), message);
  } catch (const std::exception &) {
    return RMW_RET_ERROR;
  }
  return RMW_RET_OK;
}
