// The texts of C's messages, and what is done with them: of char, and of UTF-16's units.
#pragma once
#include "rosidl_runtime_c/sequence.h"

#define COURSEKIT_C_STRING(T, Unit) \
  typedef struct T \
  { \
    Unit * data; \
    size_t size; \
    size_t capacity; \
  } T; \
  static inline bool T ## __resize_to(T * text, size_t n) \
  { \
    Unit * grown = n < SIZE_MAX / sizeof(Unit) ? (Unit *)realloc(text->data, (n + 1) * sizeof(Unit)) : NULL; \
    if (!grown) { \
      return false; \
    } \
    grown[n] = 0; \
    text->data = grown; \
    text->size = n; \
    text->capacity = n + 1; \
    return true; \
  } \
  static inline bool T ## __init(T * text) \
  { \
    if (!text) { \
      return false; \
    } \
    text->data = NULL; \
    return T ## __resize_to(text, 0); \
  } \
  static inline void T ## __fini(T * text) \
  { \
    if (text) { \
      free(text->data); \
      memset(text, 0, sizeof(*text)); \
    } \
  } \
  static inline bool T ## __are_equal(const T * a, const T * b) \
  { \
    return a && b && a->size == b->size && (!a->size || !memcmp(a->data, b->data, a->size * sizeof(Unit))); \
  } \
  static inline bool T ## __assignn(T * text, const Unit * value, size_t n) \
  { \
    if (!text || !value || !T ## __resize_to(text, n)) { \
      return false; \
    } \
    memcpy(text->data, value, n * sizeof(Unit)); \
    return true; \
  } \
  static inline bool T ## __copy(const T * from, T * to) {return from && to && T ## __assignn(to, from->data, from->size);} \
  COURSEKIT_C_SEQUENCE(T)

COURSEKIT_C_STRING(rosidl_runtime_c__String, char)
COURSEKIT_C_STRING(rosidl_runtime_c__U16String, uint_least16_t)

static inline bool rosidl_runtime_c__String__assign(rosidl_runtime_c__String * text, const char * value)
{
  return value && rosidl_runtime_c__String__assignn(text, value, strlen(value));
}
/// The number of units before the zero.
static inline size_t rosidl_runtime_c__U16String__len(const uint_least16_t * value)
{
  size_t n = 0;
  while (value && value[n]) {
    ++n;
  }
  return n;
}
static inline bool rosidl_runtime_c__U16String__assign(rosidl_runtime_c__U16String * text, const uint_least16_t * value)
{
  return rosidl_runtime_c__U16String__assignn(text, value, rosidl_runtime_c__U16String__len(value));
}
/// Take in units that are given as bytes, two for each.
static inline bool rosidl_runtime_c__U16String__assignn_from_char(
  rosidl_runtime_c__U16String * text, const char * value, size_t n)
{
  if (!text || !value || n % sizeof(uint_least16_t) || !rosidl_runtime_c__U16String__resize_to(text, n / sizeof(uint_least16_t))) {
    return false;
  }
  memcpy(text->data, value, n);
  return true;
}
static inline bool rosidl_runtime_c__U16String__resize(rosidl_runtime_c__U16String * text, size_t n)
{
  return text && rosidl_runtime_c__U16String__resize_to(text, n);
}
