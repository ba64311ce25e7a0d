// Threads that a library of the system starts for itself, to compute in parallel: OpenMP's, TBB's, OpenCV's.
//
// The session never sees them, and they see the computer's own time. To the session the thread that waits for them computes.
#pragma once

namespace coursekit
{
/// Whether the calling thread is one of these.
extern thread_local bool t_in_pool;
/// Whether a library starts a thread for itself by this function; it is remembered.
bool starts_pool(void * (*function)(void *), void * argument);
/// Whether code at that address belongs to such a library: what it waits for is one of its threads.
bool is_of_pool(const void * code);
}  // namespace coursekit
