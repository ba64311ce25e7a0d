// Messages as the bytes that travel, and the information that comes with them.
#pragma once
#include "rclcpp/get_message_type_support_handle.hpp"
#include "rclcpp/macros.hpp"
#include "rmw/serialized_message.h"
#include "rmw/types.h"

namespace rclcpp
{
class SerializedMessage
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SerializedMessage)
  explicit SerializedMessage(size_t capacity = 0) {reserve(capacity);}
  explicit SerializedMessage(std::string bytes)
  : bytes_(std::move(bytes)) {look();}
  explicit SerializedMessage(const rcl_serialized_message_t & other)
  : SerializedMessage(std::string(reinterpret_cast<const char *>(other.buffer), other.buffer_length)) {}
  SerializedMessage(const SerializedMessage & other)
  : bytes_(other.bytes()) {look();}
  SerializedMessage & operator=(const SerializedMessage & other)
  {
    bytes_ = other.bytes();
    look();
    return *this;
  }
  rcl_serialized_message_t & get_rcl_serialized_message() {return view_;}
  const rcl_serialized_message_t & get_rcl_serialized_message() const {return view_;}
  /// Hand the bytes over: whoever gets them ends them.
  rcl_serialized_message_t release_rcl_serialized_message()
  {
    rcl_serialized_message_t given{static_cast<uint8_t *>(malloc(size() ? size() : 1)), size(), size(),
      rcutils_get_default_allocator()};
    memcpy(given.buffer, view_.buffer, size());
    bytes_.clear();
    look();
    return given;
  }
  size_t size() const {return view_.buffer_length;}
  size_t capacity() const {return view_.buffer_capacity;}
  void reserve(size_t capacity)
  {
    size_t length = view_.buffer_length;
    bytes_.resize(std::max(capacity, bytes_.size()));
    look();
    view_.buffer_length = length;
  }
  /// The bytes as they are now, also where a program wrote into the buffer.
  std::string bytes() const {return std::string(reinterpret_cast<const char *>(view_.buffer), view_.buffer_length);}

private:
  void look() {view_ = {reinterpret_cast<uint8_t *>(bytes_.data()), bytes_.size(), bytes_.size(), allocator()};}
  /// C's functions let the bytes grow where they are.
  rcutils_allocator_t allocator()
  {
    return {
      [](size_t size, void * bytes) {return grow(bytes, size);}, [](void *, void *) {},
      [](void *, size_t size, void * bytes) {return grow(bytes, size);},
      [](size_t number, size_t size, void * bytes) {return grow(bytes, number * size);}, &bytes_};
  }
  static void * grow(void * bytes, size_t size)
  {
    auto own = static_cast<std::string *>(bytes);
    own->resize(size);
    return own->data();
  }
  std::string bytes_;
  rcl_serialized_message_t view_{nullptr, 0, 0};
};

/// Messages of a type to bytes and back, by the type's support.
class SerializationBase
{
public:
  explicit SerializationBase(const rosidl_message_type_support_t * type_support);
  virtual ~SerializationBase() = default;
  void serialize_message(const void * message, SerializedMessage * to) const;
  void deserialize_message(const SerializedMessage * from, void * message) const;

private:
  const coursekit::MessageType & type_;
};
template<class T>
class Serialization : public SerializationBase
{
public:
  Serialization()
  : SerializationBase(&get_message_type_support_handle<T>()) {}
};

class MessageInfo
{
public:
  MessageInfo() = default;
  explicit MessageInfo(const rmw_message_info_t & info)
  : info_(info) {}
  rmw_message_info_t & get_rmw_message_info() {return info_;}
  const rmw_message_info_t & get_rmw_message_info() const {return info_;}

private:
  rmw_message_info_t info_{};
};
}  // namespace rclcpp
