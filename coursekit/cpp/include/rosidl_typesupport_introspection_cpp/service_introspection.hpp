// What a program finds out about the two messages of a service while it runs.
#pragma once
#include "rosidl_runtime_c/service_type_support_struct.h"
#include "rosidl_typesupport_introspection_cpp/message_introspection.hpp"

namespace rosidl_typesupport_introspection_cpp
{
typedef struct ServiceMembers_s
{
  const char * service_namespace_;
  const char * service_name_;
  const MessageMembers * request_members_;
  const MessageMembers * response_members_;
} ServiceMembers;

/// The handle of a service's type whose data are its ServiceMembers.
template<class S>
const rosidl_service_type_support_t * get_service_type_support_handle()
{
  auto members_of = [](const rosidl_message_type_support_t * handle) {
      return static_cast<const MessageMembers *>(handle->data);
    };
  static const coursekit::introspection::Name name(S::coursekit_type);
  static const ServiceMembers all{
    name.space.c_str(), name.name.c_str(), members_of(get_message_type_support_handle<typename S::Request>()),
    members_of(get_message_type_support_handle<typename S::Response>())};
  static const rosidl_service_type_support_t handle{typesupport_identifier, &all, get_service_typesupport_handle_function};
  return &handle;
}
}  // namespace rosidl_typesupport_introspection_cpp
