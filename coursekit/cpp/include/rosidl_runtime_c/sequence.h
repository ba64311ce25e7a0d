// What all sequences of C's messages do; T is the type of the elements, which has __init, __fini, __are_equal and __copy.
#pragma once
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define COURSEKIT_C_SEQUENCE_TYPE(T, Sequence) \
  typedef struct Sequence \
  { \
    T * data; \
    size_t size; \
    size_t capacity; \
  } Sequence;

#define COURSEKIT_C_CREATE(T) \
  static inline T * T ## __create(void) \
  { \
    T * made = (T *)calloc(1, sizeof(T)); \
    if (made && !T ## __init(made)) { \
      free(made); \
      return NULL; \
    } \
    return made; \
  } \
  static inline void T ## __destroy(T * one) \
  { \
    if (one) { \
      T ## __fini(one); \
      free(one); \
    } \
  }

#define COURSEKIT_C_SEQUENCE(T) \
  COURSEKIT_C_SEQUENCE_TYPE(T, T ## __Sequence) \
  static inline void T ## __Sequence__fini(T ## __Sequence * all) \
  { \
    if (all) { \
      for (size_t i = 0; i < all->capacity; ++i) { \
        T ## __fini(&all->data[i]); \
      } \
      free(all->data); \
      memset(all, 0, sizeof(*all)); \
    } \
  } \
  static inline bool T ## __Sequence__init(T ## __Sequence * all, size_t size) \
  { \
    if (!all) { \
      return false; \
    } \
    memset(all, 0, sizeof(*all)); \
    if (size && !(all->data = (T *)calloc(size, sizeof(T)))) { \
      return false; \
    } \
    for (; all->size < size; all->capacity = ++all->size) { \
      if (!T ## __init(&all->data[all->size])) { \
        T ## __Sequence__fini(all); \
        return false; \
      } \
    } \
    return true; \
  } \
  static inline T ## __Sequence * T ## __Sequence__create(size_t size) \
  { \
    T ## __Sequence * made = (T ## __Sequence *)malloc(sizeof(T ## __Sequence)); \
    if (made && !T ## __Sequence__init(made, size)) { \
      free(made); \
      return NULL; \
    } \
    return made; \
  } \
  static inline void T ## __Sequence__destroy(T ## __Sequence * all) \
  { \
    T ## __Sequence__fini(all); \
    free(all); \
  } \
  static inline bool T ## __Sequence__are_equal(const T ## __Sequence * a, const T ## __Sequence * b) \
  { \
    if (!a || !b || a->size != b->size) { \
      return false; \
    } \
    for (size_t i = 0; i < a->size; ++i) { \
      if (!T ## __are_equal(&a->data[i], &b->data[i])) { \
        return false; \
      } \
    } \
    return true; \
  } \
  static inline bool T ## __Sequence__copy(const T ## __Sequence * from, T ## __Sequence * to) \
  { \
    if (!from || !to) { \
      return false; \
    } \
    if (to->capacity < from->size) { \
      T ## __Sequence larger; \
      if (!T ## __Sequence__init(&larger, from->size)) { \
        return false; \
      } \
      T ## __Sequence__fini(to); \
      *to = larger; \
    } \
    to->size = from->size; \
    for (size_t i = 0; i < from->size; ++i) { \
      if (!T ## __copy(&from->data[i], &to->data[i])) { \
        return false; \
      } \
    } \
    return true; \
  }
