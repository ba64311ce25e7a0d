// Something that is done when a block is left, under rclcpp's names.
#pragma once
#include "rcpputils/scope_exit.hpp"

namespace rclcpp
{
template<class F>
using ScopeExit = rcpputils::scope_exit<F>;
using rcpputils::make_scope_exit;
}  // namespace rclcpp
#define RCLCPP_SCOPE_EXIT RCPPUTILS_SCOPE_EXIT
