// The allocator that C's functions ask for.
#pragma once

/// Memory is the program's own; what wants an allocator takes this one and asks it for nothing.
struct rcutils_allocator_t {};
typedef rcutils_allocator_t rcl_allocator_t;
inline rcutils_allocator_t rcutils_get_default_allocator() {return {};}
inline rcl_allocator_t rcl_get_default_allocator() {return {};}
