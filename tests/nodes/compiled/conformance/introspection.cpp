// Messages looked into by the names of their members, as tools do that know no class.
#include <memory>

#include "check.hpp"
#include "rosidl_typesupport_introspection_cpp/field_types.hpp"
#include "rosidl_typesupport_introspection_cpp/identifier.hpp"
#include "rosidl_typesupport_introspection_cpp/message_introspection.hpp"
#include "rosidl_typesupport_introspection_cpp/message_type_support_decl.hpp"
#include "rosidl_typesupport_introspection_cpp/service_introspection.hpp"
#include "rosidl_typesupport_introspection_cpp/service_type_support_decl.hpp"
#include "test_msgs/msg/arrays.hpp"
#include "test_msgs/msg/basic_types.hpp"
#include "test_msgs/msg/bounded_sequences.hpp"
#include "test_msgs/msg/empty.hpp"
#include "test_msgs/msg/nested.hpp"
#include "test_msgs/msg/strings.hpp"
#include "test_msgs/msg/unbounded_sequences.hpp"
#include "test_msgs/msg/w_strings.hpp"
#include "test_msgs/srv/basic_types.hpp"

namespace facts = rosidl_typesupport_introspection_cpp;
using namespace test_msgs::msg;

static const facts::MessageMembers & members_of(const rosidl_message_type_support_t * handle)
{
  return *static_cast<const facts::MessageMembers *>(handle->data);
}
template<class M>
const facts::MessageMembers & members_of() {return members_of(facts::get_message_type_support_handle<M>());}
static const facts::MessageMember & member(const facts::MessageMembers & all, const std::string & name)
{
  for (uint32_t i = 0; i < all.member_count_; ++i) {
    if (all.members_[i].name_ == name) {
      return all.members_[i];
    }
  }
  throw std::out_of_range(name);
}

static void values()
{
  const auto handle = facts::get_message_type_support_handle<BasicTypes>();
  equal("who looks into it", std::string(handle->typesupport_identifier), facts::typesupport_identifier);
  check("asked for itself", get_message_typesupport_handle(handle, facts::typesupport_identifier) == handle);
  check("asked for another", get_message_typesupport_handle(handle, "rosidl_typesupport_cpp") == nullptr);
  const auto & all = members_of(handle);
  equal("its namespace", std::string(all.message_namespace_), "test_msgs::msg");
  equal("its name", std::string(all.message_name_), "BasicTypes");
  equal("its size", all.size_of_, sizeof(BasicTypes));
  std::string kinds;
  for (uint32_t i = 0; i < all.member_count_; ++i) {
    kinds += std::to_string(all.members_[i].type_id_) + " ";
  }
  equal("bool, byte, char, floats and integers", kinds, "6 7 8 1 2 9 8 11 10 13 12 15 14 ");

  auto memory = std::make_unique<std::aligned_storage_t<sizeof(BasicTypes), alignof(BasicTypes)>>();
  all.init_function(memory.get(), rosidl_runtime_cpp::MessageInitialization::ALL);
  auto message = reinterpret_cast<BasicTypes *>(memory.get());
  message->int32_value = -7;
  const auto place = reinterpret_cast<char *>(message) + member(all, "int32_value").offset_;
  equal("a value in its place", *reinterpret_cast<int32_t *>(place), -7);
  all.fini_function(message);
  equal("what is empty in ROS has a member", members_of<Empty>().member_count_, 1u);
}

static void texts()
{
  const auto & all = members_of<Strings>();
  equal("a text", member(all, "string_value").type_id_, facts::ROS_TYPE_STRING);
  equal("a text without a bound", member(all, "string_value").string_upper_bound_, 0u);
  equal("a text with one", member(all, "bounded_string_value").string_upper_bound_, 22u);
  equal("a wide text", member(members_of<WStrings>(), "wstring_value").type_id_, facts::ROS_TYPE_WSTRING);
}

static void arrays()
{
  const auto & fixed = member(members_of<Arrays>(), "int16_values");
  check("a fixed array", fixed.is_array_ && fixed.array_size_ == 3 && !fixed.is_upper_bound_ && !fixed.resize_function);
  Arrays arrays;
  arrays.int16_values = {1, 2, 3};
  check("has its size", fixed.size_function(&arrays.int16_values) == 3);
  equal("and places", *static_cast<const int16_t *>(fixed.get_const_function(&arrays.int16_values, 2)), 3);

  const auto & bounded = member(members_of<BoundedSequences>(), "string_values");
  check("a bounded array", bounded.array_size_ == 3 && bounded.is_upper_bound_);
  BoundedSequences sequences;
  bounded.resize_function(&sequences.string_values, 2);
  *static_cast<std::string *>(bounded.get_function(&sequences.string_values, 1)) = "last";
  check("grows", sequences.string_values == decltype(sequences.string_values){"", "last"});
  throws<std::length_error>("up to its bound", [&] {bounded.resize_function(&sequences.string_values, 4);});

  const auto & flags = member(members_of<UnboundedSequences>(), "bool_values");
  UnboundedSequences free;
  free.bool_values = {false, true};
  bool flag = false;
  flags.fetch_function(&free.bool_values, 1, &flag);
  flags.assign_function(&free.bool_values, 0, &flag);
  check("a bool is fetched and assigned", flag && free.bool_values[0]);
  check("a packed one has no place", !flags.get_function && !flags.get_const_function && flags.array_size_ == 0);
  check("a bool of a fixed array has one", member(members_of<Arrays>(), "bool_values").get_function != nullptr);
}

static void messages()
{
  const auto & inner = member(members_of<Nested>(), "basic_types_value");
  equal("a message within another", inner.type_id_, facts::ROS_TYPE_MESSAGE);
  equal("has its own members", std::string(members_of(inner.members_).message_name_), "BasicTypes");
  const auto handle = facts::get_service_type_support_handle<test_msgs::srv::BasicTypes>();
  const auto & service = *static_cast<const facts::ServiceMembers *>(handle->data);
  equal("a service", std::string(service.service_namespace_) + " " + service.service_name_, "test_msgs::srv BasicTypes");
  equal("has a request", std::string(service.request_members_->message_name_), "BasicTypes_Request");
  equal("and a response", std::string(service.response_members_->message_name_), "BasicTypes_Response");
  check("itself, in C", get_service_typesupport_handle(handle, facts::typesupport_identifier) == handle);
  check("no service of another", get_service_typesupport_handle(handle, "rosidl_typesupport_cpp") == nullptr);
  const BasicTypes message;
  throws<std::runtime_error>("who looks into messages makes no bytes of them", [&] {
      rclcpp::SerializedMessage bytes;
      rclcpp::SerializationBase(facts::get_message_type_support_handle<BasicTypes>()).serialize_message(&message, &bytes);
    });
}

int main()
{
  values();
  texts();
  arrays();
  messages();
}
