#pragma once

namespace rosidl_runtime_cpp
{
/// How a message's constructor fills its fields; here they always get their defaults.
enum class MessageInitialization {ALL, SKIP, ZERO, DEFAULTS_ONLY};
}  // namespace rosidl_runtime_cpp
