// A value, or the text that tells why there is none.
#pragma once
#include "tl_expected/expected.hpp"

namespace nonstd
{
using tl::bad_expected_access;
using tl::expected;
using tl::make_unexpected;
template<class E>
using unexpected_type = tl::unexpected<E>;
}  // namespace nonstd
