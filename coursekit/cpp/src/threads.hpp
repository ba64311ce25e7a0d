// Waiting on the virtual clock for what another thread of the program does.
#pragma once
#include <cstdint>

namespace coursekit
{
/// Wait until somebody wakes those that wait on `what`, at most until then (steady; negative: without end).
bool block(const void * what, int64_t until);
/// Wake who waits on it: one, or all.
void unblock(const void * what, bool all);
}  // namespace coursekit
