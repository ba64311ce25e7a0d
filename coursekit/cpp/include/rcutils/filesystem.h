// Files and folders, in C.
#pragma once
#include <cerrno>

#include "rcpputils/filesystem_helper.hpp"
#include "rcutils/strdup.h"

inline bool rcutils_exists(const char * path) {return path && rcpputils::fs::exists(path);}
inline bool rcutils_is_directory(const char * path) {return path && rcpputils::fs::is_directory(path);}
inline bool rcutils_is_file(const char * path) {return path && rcpputils::fs::is_regular_file(path);}
inline bool rcutils_mkdir(const char * path)
{
  return path && rcpputils::fs::path(path).is_absolute() && rcpputils::fs::create_directories(path);
}
inline size_t rcutils_get_file_size(const char * path) {return rcutils_is_file(path) ? rcpputils::fs::file_size(path) : 0;}
/// Both paths as one, which the program frees.
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
