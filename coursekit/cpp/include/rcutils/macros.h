// What compilers are told in C.
#pragma once
#if defined(__GNUC__)
#define RCUTILS_WARN_UNUSED __attribute__((warn_unused_result))
#define RCUTILS_LIKELY(x) __builtin_expect((x), 1)
#define RCUTILS_UNLIKELY(x) __builtin_expect((x), 0)
#define RCUTILS_ATTRIBUTE_PRINTF_FORMAT(format_index, first) __attribute__((format(printf, format_index, first)))
#else
#define RCUTILS_WARN_UNUSED
#define RCUTILS_LIKELY(x) (x)
#define RCUTILS_UNLIKELY(x) (x)
#define RCUTILS_ATTRIBUTE_PRINTF_FORMAT(format_index, first)
#endif
#define RCUTILS_THREAD_LOCAL thread_local
#define RCUTILS_STRINGIFY_IMPL(x) #x
#define RCUTILS_STRINGIFY(x) RCUTILS_STRINGIFY_IMPL(x)
#define RCUTILS_JOIN_IMPL(a, b) a ## b
#define RCUTILS_JOIN(a, b) RCUTILS_JOIN_IMPL(a, b)
#define RCUTILS_UNUSED(x) (void)(x)
#define RCUTILS_CAN_RETURN_WITH_ERROR_OF(...)
#define RCUTILS_CAN_SET_MSG_AND_RETURN_WITH_ERROR_OF(...)
