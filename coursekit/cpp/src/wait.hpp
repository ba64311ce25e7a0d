// What wait sets and waitables share: the numbers of what is waited for, and who of them is ready.
#pragma once
#include <vector>

#include "rcl/wait.h"

namespace coursekit
{
/// The session's numbers of all that is in a set, kind by kind.
std::vector<int64_t> numbers_in(rcl_wait_set_t & set);
/// Make null what is not ready; `ready` has them in the order of numbers_in().
void keep_ready(rcl_wait_set_t & set, const std::vector<bool> & ready);
}  // namespace coursekit
