// What a program finds out about the members of a message while it runs: their names, types and places.
#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <new>
#include <string>
#include <type_traits>
#include <vector>

#include "rosidl_runtime_cpp/message.hpp"
#include "rosidl_typesupport_cpp/message_type_support.hpp"

namespace rosidl_typesupport_introspection_cpp
{
inline const char * typesupport_identifier = "rosidl_typesupport_introspection_cpp";

constexpr uint8_t ROS_TYPE_FLOAT = 1, ROS_TYPE_DOUBLE = 2, ROS_TYPE_LONG_DOUBLE = 3, ROS_TYPE_CHAR = 4, ROS_TYPE_WCHAR = 5,
  ROS_TYPE_BOOLEAN = 6, ROS_TYPE_OCTET = 7, ROS_TYPE_UINT8 = 8, ROS_TYPE_INT8 = 9, ROS_TYPE_UINT16 = 10, ROS_TYPE_INT16 = 11,
  ROS_TYPE_UINT32 = 12, ROS_TYPE_INT32 = 13, ROS_TYPE_UINT64 = 14, ROS_TYPE_INT64 = 15, ROS_TYPE_STRING = 16,
  ROS_TYPE_WSTRING = 17, ROS_TYPE_MESSAGE = 18;
constexpr uint8_t ROS_TYPE_FLOAT32 = ROS_TYPE_FLOAT, ROS_TYPE_FLOAT64 = ROS_TYPE_DOUBLE, ROS_TYPE_BOOL = ROS_TYPE_BOOLEAN,
  ROS_TYPE_BYTE = ROS_TYPE_OCTET;

/// A member. The functions are those of an array; where it has packed bools there are no places of single items.
typedef struct MessageMember_s
{
  const char * name_;
  uint8_t type_id_;
  size_t string_upper_bound_;
  /// Of a message: its own members.
  const rosidl_message_type_support_t * members_;
  bool is_array_;
  /// The size of a fixed array, the most of a bounded one, otherwise 0.
  size_t array_size_;
  bool is_upper_bound_;
  uint32_t offset_;
  /// Always null, as in Humble.
  const void * default_value_;
  size_t (* size_function)(const void * member);
  const void * (*get_const_function)(const void * member, size_t index);
  void * (*get_function)(void * member, size_t index);
  void (* fetch_function)(const void * member, size_t index, void * to);
  void (* assign_function)(void * member, size_t index, const void * from);
  /// Null for a fixed array.
  void (* resize_function)(void * member, size_t size);
} MessageMember;

typedef struct MessageMembers_s
{
  const char * message_namespace_;
  const char * message_name_;
  uint32_t member_count_;
  size_t size_of_;
  const MessageMember * members_;
  void (* init_function)(void * memory, rosidl_runtime_cpp::MessageInitialization how);
  void (* fini_function)(void * message);
} MessageMembers;

/// The handle of a message's type whose data are its MessageMembers.
template<class M>
const rosidl_message_type_support_t * get_message_type_support_handle();
}  // namespace rosidl_typesupport_introspection_cpp

namespace coursekit::introspection
{
namespace facts = rosidl_typesupport_introspection_cpp;

/// Into namespace and name: "std_msgs::msg" and "String".
struct Name
{
  explicit Name(const std::string & full)
  : space(full.substr(0, full.rfind('/'))), name(full.substr(full.rfind('/') + 1))
  {
    space.replace(space.find('/'), 1, "::");
  }
  std::string space, name;
};

template<class T>
constexpr uint8_t type_id()
{
  if constexpr (std::is_floating_point_v<T>) {
    return sizeof(T) == 4 ? facts::ROS_TYPE_FLOAT : facts::ROS_TYPE_DOUBLE;
  } else if constexpr (std::is_same_v<T, bool>) {
    return facts::ROS_TYPE_BOOLEAN;
  } else if constexpr (std::is_integral_v<T>) {
    constexpr int doublings = (sizeof(T) > 1) + (sizeof(T) > 2) + (sizeof(T) > 4);
    return static_cast<uint8_t>(facts::ROS_TYPE_UINT8 + 2 * doublings + std::is_signed_v<T>);
  } else if constexpr (std::is_same_v<T, std::string>) {
    return facts::ROS_TYPE_STRING;
  } else {
    return std::is_same_v<T, std::u16string> ? facts::ROS_TYPE_WSTRING : facts::ROS_TYPE_MESSAGE;
  }
}

template<class T>
struct Bound
{
  static constexpr size_t size = 0;
  static constexpr bool is_fixed = false;
};
template<class T, size_t N>
struct Bound<std::array<T, N>>
{
  static constexpr size_t size = N;
  static constexpr bool is_fixed = true;
};
template<class T, size_t N>
struct Bound<rosidl_runtime_cpp::BoundedVector<T, N>>
{
  static constexpr size_t size = N;
  static constexpr bool is_fixed = false;
};

/// The functions of an array of type L.
template<class L>
void describe_list(facts::MessageMember & member)
{
  using Item = typename L::value_type;
  member.is_array_ = true;
  member.array_size_ = Bound<L>::size;
  member.is_upper_bound_ = Bound<L>::size && !Bound<L>::is_fixed;
  member.size_function = [](const void * list) {return static_cast<const L *>(list)->size();};
  member.fetch_function = [](const void * list, size_t index, void * to) {
      *static_cast<Item *>(to) = (*static_cast<const L *>(list))[index];
    };
  member.assign_function = [](void * list, size_t index, const void * from) {
      (*static_cast<L *>(list))[index] = *static_cast<const Item *>(from);
    };
  if constexpr (!std::is_same_v<Item, bool> || Bound<L>::is_fixed) {
    member.get_const_function = [](const void * list, size_t index) -> const void * {
        return &(*static_cast<const L *>(list))[index];
      };
    member.get_function = [](void * list, size_t index) -> void * {return &(*static_cast<L *>(list))[index];};
  }
  if constexpr (!Bound<L>::is_fixed) {
    member.resize_function = [](void * list, size_t size) {static_cast<L *>(list)->resize(size);};
  }
}

/// A value's type, or that of an array's items.
template<class T>
void describe_item(facts::MessageMember & member, bool is_octet, size_t bound)
{
  member.type_id_ = is_octet ? facts::ROS_TYPE_OCTET : type_id<T>();
  member.string_upper_bound_ = bound;
  if constexpr (is_message<T>::value) {
    member.members_ = facts::get_message_type_support_handle<T>();
  }
}

template<class M, class = void>
struct TextBounds
{
  static size_t of(const char *) {return 0;}
};
template<class M>
struct TextBounds<M, std::void_t<decltype(M::coursekit_text_bounds)>>
{
  static size_t of(const char * name)
  {
    for (const auto & bound : M::coursekit_text_bounds) {
      if (std::strcmp(bound.first, name) == 0) {
        return bound.second;
      }
    }
    return 0;
  }
};

template<class M>
std::vector<facts::MessageMember> members_of()
{
  std::vector<facts::MessageMember> members;
  const M message(rosidl_runtime_cpp::MessageInitialization::ZERO);
  auto visit = [&](const char * name, const auto & field) {
      using T = std::decay_t<decltype(field)>;
      facts::MessageMember member{};
      member.name_ = name;
      member.offset_ =
        static_cast<uint32_t>(reinterpret_cast<const char *>(&field) - reinterpret_cast<const char *>(&message));
      const bool is_octet = yaml::octets<M>::has(name);
      if constexpr (yaml::is_list<T>) {
        describe_item<typename T::value_type>(member, is_octet, TextBounds<M>::of(name));
        describe_list<T>(member);
      } else {
        describe_item<T>(member, is_octet, TextBounds<M>::of(name));
      }
      members.push_back(member);
    };
  M::each_field(visit, message);
  return members;
}
}  // namespace coursekit::introspection

namespace rosidl_typesupport_introspection_cpp
{
template<class M>
const rosidl_message_type_support_t * get_message_type_support_handle()
{
  static const coursekit::introspection::Name name(M::coursekit_type);
  static const std::vector<MessageMember> members = coursekit::introspection::members_of<M>();
  static const MessageMembers all{
    name.space.c_str(), name.name.c_str(), static_cast<uint32_t>(members.size()), sizeof(M), members.data(),
    [](void * memory, rosidl_runtime_cpp::MessageInitialization how) {new (memory) M(how);},
    [](void * message) {static_cast<M *>(message)->~M();}};
  static const rosidl_message_type_support_t handle{typesupport_identifier, &all, get_message_typesupport_handle_function};
  return &handle;
}
}  // namespace rosidl_typesupport_introspection_cpp
