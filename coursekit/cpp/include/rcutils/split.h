// A text taken apart, and parts put together, in C.
#pragma once
#include "rcutils/strdup.h"
#include "rcutils/types.h"

/// Whether all texts have found memory; the list is ended where not.
inline rcutils_ret_t coursekit_complete(rcutils_string_array_t * parts)
{
  for (size_t i = 0; i < parts->size; ++i) {
    if (!parts->data[i]) {
      return rcutils_string_array_fini(parts) == RCUTILS_RET_OK ? RCUTILS_RET_BAD_ALLOC : RCUTILS_RET_ERROR;
    }
  }
  return RCUTILS_RET_OK;
}
/// The parts between delimiters that are not empty.
inline rcutils_ret_t rcutils_split(
  const char * text, char delimiter, rcutils_allocator_t allocator, rcutils_string_array_t * parts)
{
  if (!parts) {
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  size_t count = 0;
  for (const char * c = text; c && *c; ++c) {
    count += *c != delimiter && (c == text || c[-1] == delimiter);
  }
  rcutils_ret_t made = rcutils_string_array_init(parts, count, &allocator);
  for (size_t i = 0; made == RCUTILS_RET_OK && i < count; ++i) {
    text += strspn(text, std::string(1, delimiter).c_str());
    size_t length = strcspn(text, std::string(1, delimiter).c_str());
    parts->data[i] = rcutils_strndup(text, length, allocator);
    text += length;
  }
  return made == RCUTILS_RET_OK ? coursekit_complete(parts) : made;
}
/// What stands before the last delimiter, and what behind it.
inline rcutils_ret_t rcutils_split_last(
  const char * text, char delimiter, rcutils_allocator_t allocator, rcutils_string_array_t * parts)
{
  if (!parts) {
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  std::string left = text ? text : "";
  left.erase(left.find_last_not_of(delimiter) + 1);
  left.erase(0, std::min(left.find_first_not_of(delimiter), left.size()));
  size_t last = left.rfind(delimiter);
  bool both = last != left.npos;
  rcutils_ret_t made = rcutils_string_array_init(parts, left.empty() ? 0 : both ? 2 : 1, &allocator);
  if (made == RCUTILS_RET_OK && !left.empty()) {
    size_t end = both ? left.find_last_not_of(delimiter, last) + 1 : left.size();
    parts->data[0] = rcutils_strndup(left.c_str(), end, allocator);
    if (both) {
      parts->data[1] = rcutils_strdup(left.c_str() + last + 1, allocator);
    }
  }
  return made == RCUTILS_RET_OK ? coursekit_complete(parts) : made;
}
