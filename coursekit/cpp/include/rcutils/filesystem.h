// Files and folders, in C.
#pragma once
#include <cerrno>

#include "rcpputils/filesystem_helper.hpp"
#include "rcutils/env.h"
#include "rcutils/strdup.h"
#include "rcutils/types.h"

inline bool rcutils_exists(const char * path) {return path && rcpputils::fs::exists(path);}
inline bool rcutils_is_directory(const char * path) {return path && rcpputils::fs::is_directory(path);}
inline bool rcutils_is_file(const char * path) {return path && rcpputils::fs::is_regular_file(path);}
bool rcutils_is_readable(const char * path);
bool rcutils_is_writable(const char * path);
inline bool rcutils_is_readable_and_writable(const char * path) {return rcutils_is_readable(path) && rcutils_is_writable(path);}
/// Make one folder of an absolute path; whether it is there.
bool rcutils_mkdir(const char * path);
inline size_t rcutils_get_file_size(const char * path) {return rcutils_is_file(path) ? rcpputils::fs::file_size(path) : 0;}
/// The bytes of a folder's files and of those below it to so many levels; all levels for 0.
rcutils_ret_t rcutils_calculate_directory_size_with_recursion(
  const char * path, size_t max_depth, uint64_t * size, rcutils_allocator_t allocator);
inline rcutils_ret_t rcutils_calculate_directory_size(const char * path, uint64_t * size, rcutils_allocator_t allocator)
{
  return rcutils_calculate_directory_size_with_recursion(path, 1, size, allocator);
}
/// What a folder has, one name after the other; null where there is no such folder.
typedef struct rcutils_dir_iter_t
{
  const char * entry_name;
  rcutils_allocator_t allocator;
  struct rcutils_dir_iter_state_t * state;
} rcutils_dir_iter_t;
rcutils_dir_iter_t * rcutils_dir_iter_start(const char * path, rcutils_allocator_t allocator);
bool rcutils_dir_iter_next(rcutils_dir_iter_t * iter);
void rcutils_dir_iter_end(rcutils_dir_iter_t * iter);

/// A path with the system's separators, which the program gives back to the allocator.
inline char * rcutils_to_native_path(const char * path, rcutils_allocator_t allocator)
{
  return path ? rcutils_strdup(rcpputils::fs::path(path).string().c_str(), allocator) : nullptr;
}
/// A path with the user's home in the place of a ~ at its beginning.
inline char * rcutils_expand_user(const char * path, rcutils_allocator_t allocator)
{
  const bool at_home = path && path[0] == '~' && (!path[1] || path[1] == '/' || path[1] == '\\');
  const char * home = at_home ? rcutils_get_home_dir() : "";
  return path && home ? rcutils_strdup((std::string(home) + (path + at_home)).c_str(), allocator) : nullptr;
}
/// Both paths as one.
inline char * rcutils_join_path(const char * left, const char * right, rcutils_allocator_t allocator)
{
  if (!left || !right) {
    return nullptr;
  }
  return rcutils_strdup((std::string(left) + rcpputils::fs::kPreferredSeparator + right).c_str(), allocator);
}
inline bool rcutils_get_cwd(char * buffer, size_t size)
{
  std::string now = rcpputils::fs::current_path().string();
  if (!buffer || now.size() + 1 > size) {
    return false;
  }
  memcpy(buffer, now.c_str(), now.size() + 1);
  return true;
}
