// Sequences of numbers in C's messages.
#pragma once
#include "rosidl_runtime_c/sequence.h"

#define COURSEKIT_C_NUMBERS(S, T) \
  COURSEKIT_C_SEQUENCE_TYPE(T, S) \
  static inline bool S ## __init(S * all, size_t size) \
  { \
    if (!all) { \
      return false; \
    } \
    memset(all, 0, sizeof(*all)); \
    if (size && !(all->data = (T *)calloc(size, sizeof(T)))) { \
      return false; \
    } \
    all->size = all->capacity = size; \
    return true; \
  } \
  static inline void S ## __fini(S * all) \
  { \
    if (all) { \
      free(all->data); \
      memset(all, 0, sizeof(*all)); \
    } \
  } \
  static inline bool S ## __are_equal(const S * a, const S * b) \
  { \
    if (!a || !b || a->size != b->size) { \
      return false; \
    } \
    for (size_t i = 0; i < a->size; ++i) { \
      if (a->data[i] != b->data[i]) { \
        return false; \
      } \
    } \
    return true; \
  } \
  static inline bool S ## __copy(const S * from, S * to) \
  { \
    if (!from || !to) { \
      return false; \
    } \
    if (to->capacity < from->size) { \
      T * grown = (T *)realloc(to->data, from->size * sizeof(T)); \
      if (!grown) { \
        return false; \
      } \
      to->data = grown; \
      to->capacity = from->size; \
    } \
    if (from->size) { \
      memcpy(to->data, from->data, from->size * sizeof(T)); \
    } \
    to->size = from->size; \
    return true; \
  }

COURSEKIT_C_NUMBERS(rosidl_runtime_c__float__Sequence, float)
COURSEKIT_C_NUMBERS(rosidl_runtime_c__double__Sequence, double)
COURSEKIT_C_NUMBERS(rosidl_runtime_c__long_double__Sequence, long double)
COURSEKIT_C_NUMBERS(rosidl_runtime_c__char__Sequence, signed char)
COURSEKIT_C_NUMBERS(rosidl_runtime_c__wchar__Sequence, uint16_t)
COURSEKIT_C_NUMBERS(rosidl_runtime_c__boolean__Sequence, bool)
COURSEKIT_C_NUMBERS(rosidl_runtime_c__octet__Sequence, uint8_t)
COURSEKIT_C_NUMBERS(rosidl_runtime_c__uint8__Sequence, uint8_t)
COURSEKIT_C_NUMBERS(rosidl_runtime_c__int8__Sequence, int8_t)
COURSEKIT_C_NUMBERS(rosidl_runtime_c__uint16__Sequence, uint16_t)
COURSEKIT_C_NUMBERS(rosidl_runtime_c__int16__Sequence, int16_t)
COURSEKIT_C_NUMBERS(rosidl_runtime_c__uint32__Sequence, uint32_t)
COURSEKIT_C_NUMBERS(rosidl_runtime_c__int32__Sequence, int32_t)
COURSEKIT_C_NUMBERS(rosidl_runtime_c__uint64__Sequence, uint64_t)
COURSEKIT_C_NUMBERS(rosidl_runtime_c__int64__Sequence, int64_t)

/// An earlier name of a sequence, which code from before ROS 2 Dashing uses.
#define COURSEKIT_C_EARLIER_NAME(Earlier, S) \
  typedef S Earlier; \
  static inline bool Earlier ## __init(Earlier * all, size_t size) {return S ## __init(all, size);} \
  static inline void Earlier ## __fini(Earlier * all) {S ## __fini(all);} \
  static inline bool Earlier ## __are_equal(const Earlier * a, const Earlier * b) {return S ## __are_equal(a, b);} \
  static inline bool Earlier ## __copy(const Earlier * from, Earlier * to) {return S ## __copy(from, to);}

COURSEKIT_C_EARLIER_NAME(rosidl_runtime_c__bool__Sequence, rosidl_runtime_c__boolean__Sequence)
COURSEKIT_C_EARLIER_NAME(rosidl_runtime_c__byte__Sequence, rosidl_runtime_c__octet__Sequence)
COURSEKIT_C_EARLIER_NAME(rosidl_runtime_c__float32__Sequence, rosidl_runtime_c__float__Sequence)
COURSEKIT_C_EARLIER_NAME(rosidl_runtime_c__float64__Sequence, rosidl_runtime_c__double__Sequence)
