#pragma once

namespace rosidl_runtime_cpp
{
/// How a message's constructor fills its fields: with zeros and then the defaults of its definition, or with one of the two.
enum class MessageInitialization {ALL, SKIP, ZERO, DEFAULTS_ONLY};
}  // namespace rosidl_runtime_cpp

namespace coursekit
{
using Initialization = rosidl_runtime_cpp::MessageInitialization;
constexpr bool with_zeros(Initialization how) {return how == Initialization::ALL || how == Initialization::ZERO;}
constexpr bool with_defaults(Initialization how) {return how == Initialization::ALL || how == Initialization::DEFAULTS_ONLY;}
/// Where it is not what messages in a block begin with.
constexpr bool unlike_default(Initialization how) {return how != Initialization::ALL;}
}  // namespace coursekit
