// The older names of rsl's validators.
#pragma once
#include "rsl/parameter_validators.hpp"
#if __has_include(<fmt/format.h>)
#include <fmt/format.h>
#endif

namespace parameter_traits
{
using namespace rsl;  // NOLINT
using ValidateResult = tl::expected<void, std::string>;
using ok = ValidateResult;
#if __has_include(<fmt/format.h>)
template<class ... Args>
ValidateResult make_error(const std::string & format, Args ... args)
{
  return tl::make_unexpected(fmt::vformat(format, fmt::make_format_args(args ...)));
}
#endif
}  // namespace parameter_traits
