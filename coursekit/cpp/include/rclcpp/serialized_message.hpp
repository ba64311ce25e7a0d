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
  : bytes_(std::move(bytes)) {look(bytes_.size());}
  explicit SerializedMessage(const rcl_serialized_message_t & other)
  : SerializedMessage(other.buffer_capacity)
  {
    if (other.buffer_length) {
      memcpy(view_.buffer, other.buffer, other.buffer_length);
    }
    view_.buffer_length = other.buffer_length;
  }
  /// Take a message of C's over: it is empty afterwards.
  explicit SerializedMessage(rcl_serialized_message_t && other)
  : SerializedMessage(static_cast<const rcl_serialized_message_t &>(other))
  {
    (void)rmw_serialized_message_fini(&other);
    other = rmw_get_zero_initialized_serialized_message();
  }
  SerializedMessage(const SerializedMessage & other)
  : bytes_(other.bytes_) {look(other.size());}
  SerializedMessage(SerializedMessage && other) noexcept {take(other);}
  SerializedMessage & operator=(const SerializedMessage & other)
  {
    bytes_ = other.bytes_;
    look(other.size());
    return *this;
  }
  SerializedMessage & operator=(SerializedMessage && other) noexcept
  {
    take(other);
    return *this;
  }
  SerializedMessage & operator=(const rcl_serialized_message_t & other) {return *this = SerializedMessage(other);}
  SerializedMessage & operator=(rcl_serialized_message_t && other) {return *this = SerializedMessage(std::move(other));}
  rcl_serialized_message_t & get_rcl_serialized_message() {return view_;}
  const rcl_serialized_message_t & get_rcl_serialized_message() const {return view_;}
  /// Hand the bytes over: whoever gets them ends them.
  rcl_serialized_message_t release_rcl_serialized_message()
  {
    const rcutils_allocator_t allocator = rcutils_get_default_allocator();
    rcl_serialized_message_t given{static_cast<uint8_t *>(malloc(capacity() ? capacity() : 1)), size(), capacity(), allocator};
    memcpy(given.buffer, bytes_.data(), capacity());
    bytes_.clear();
    look(0);
    return given;
  }
  size_t size() const {return view_.buffer_length;}
  size_t capacity() const {return view_.buffer_capacity;}
  void reserve(size_t capacity)
  {
    bytes_.resize(std::max(capacity, bytes_.size()));
    look(size());
  }
  /// The bytes as they are now, also where a program wrote into the buffer.
  std::string bytes() const
  {
    return view_.buffer ? std::string(reinterpret_cast<const char *>(view_.buffer), view_.buffer_length) : std::string();
  }

private:
  /// Show C's functions the bytes, of which so many are the message's.
  void look(size_t length)
  {
    auto buffer = bytes_.empty() ? nullptr : reinterpret_cast<uint8_t *>(bytes_.data());
    view_ = {buffer, length, bytes_.size(), allocator()};
  }
  void take(SerializedMessage & other)
  {
    const size_t length = other.size();
    bytes_ = std::move(other.bytes_);
    other.bytes_.clear();
    other.look(0);
    look(length);
  }
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
