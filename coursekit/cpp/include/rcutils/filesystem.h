// Files and folders, in C. The program gives new texts back to the allocator.
#pragma once
#include "rcutils/env.h"
#include "rcutils/strdup.h"
#include "rcutils/types.h"

bool rcutils_exists(const char * path);
bool rcutils_is_directory(const char * path);
bool rcutils_is_file(const char * path);
bool rcutils_is_readable(const char * path);
bool rcutils_is_writable(const char * path);
inline bool rcutils_is_readable_and_writable(const char * path) {return rcutils_is_readable(path) && rcutils_is_writable(path);}
/// Make one folder of an absolute path; whether it is there.
bool rcutils_mkdir(const char * path);
/// The bytes of a file; 0 for what is none.
size_t rcutils_get_file_size(const char * path);
bool rcutils_get_cwd(char * buffer, size_t size);
/// Both paths as one.
char * rcutils_join_path(const char * left, const char * right, rcutils_allocator_t allocator);
/// A path with the system's separators.
char * rcutils_to_native_path(const char * path, rcutils_allocator_t allocator);
/// A path with the user's home in the place of a ~ at its beginning.
char * rcutils_expand_user(const char * path, rcutils_allocator_t allocator);

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
