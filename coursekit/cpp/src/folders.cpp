// Files and folders in C: whether they are there, what they have, how much it is, and who may read it.
#include <algorithm>
#include <filesystem>
#include <new>
#include <string>
#include <vector>

#include "rcutils/error_handling.h"
#include "rcutils/filesystem.h"

namespace files = std::filesystem;

struct rcutils_dir_iter_state_t
{
  std::vector<std::string> names;
  size_t at = 0;
};

static files::file_status status_of(const char * path)
{
  std::error_code why_not;
  return files::status(path ? path : "", why_not);
}
static bool permits(const char * path, files::perms what)
{
  const files::file_status found = status_of(path);
  return files::exists(found) && (found.permissions() & what) != files::perms::none;
}
bool rcutils_exists(const char * path) {return files::exists(status_of(path));}
bool rcutils_is_directory(const char * path) {return files::is_directory(status_of(path));}
bool rcutils_is_file(const char * path) {return files::is_regular_file(status_of(path));}
bool rcutils_is_readable(const char * path) {return permits(path, files::perms::owner_read);}
bool rcutils_is_writable(const char * path) {return permits(path, files::perms::owner_write);}

bool rcutils_mkdir(const char * path)
{
  std::error_code why_not;
  return path && files::path(path).is_absolute() &&
         (files::create_directory(path, why_not) || files::is_directory(path, why_not));
}

size_t rcutils_get_file_size(const char * path)
{
  std::error_code why_not;
  const auto size = rcutils_is_file(path) ? files::file_size(path, why_not) : 0;
  return why_not ? 0 : static_cast<size_t>(size);
}
bool rcutils_get_cwd(char * buffer, size_t size)
{
  std::error_code why_not;
  const std::string now = files::current_path(why_not).string();
  if (!buffer || why_not || now.size() + 1 > size) {
    return false;
  }
  memcpy(buffer, now.c_str(), now.size() + 1);
  return true;
}

static constexpr char separator = static_cast<char>(files::path::preferred_separator);
char * rcutils_join_path(const char * left, const char * right, rcutils_allocator_t allocator)
{
  return left && right ? rcutils_strdup((std::string(left) + separator + right).c_str(), allocator) : nullptr;
}
char * rcutils_to_native_path(const char * path, rcutils_allocator_t allocator)
{
  char * made = rcutils_strdup(path, allocator);
  if (made) {
    std::replace(made, made + strlen(made), '/', separator);
  }
  return made;
}
char * rcutils_expand_user(const char * path, rcutils_allocator_t allocator)
{
  const bool at_home = path && path[0] == '~' && (!path[1] || path[1] == '/' || path[1] == '\\');
  const char * home = at_home ? rcutils_get_home_dir() : "";
  return path && home ? rcutils_strdup((std::string(home) + (path + at_home)).c_str(), allocator) : nullptr;
}

static uint64_t size_of(const files::path & folder, size_t levels)
{
  uint64_t size = 0;
  for (const auto & entry : files::directory_iterator(folder)) {
    if (entry.is_directory()) {
      size += levels != 1 ? size_of(entry.path(), levels ? levels - 1 : 0) : 0;
    } else if (entry.is_regular_file()) {
      size += entry.file_size();
    }
  }
  return size;
}
rcutils_ret_t rcutils_calculate_directory_size_with_recursion(
  const char * path, size_t max_depth, uint64_t * size, rcutils_allocator_t)
{
  RCUTILS_CHECK_ARGUMENT_FOR_NULL(path, RCUTILS_RET_INVALID_ARGUMENT);
  RCUTILS_CHECK_ARGUMENT_FOR_NULL(size, RCUTILS_RET_INVALID_ARGUMENT);
  try {
    *size = size_of(path, max_depth);
    return RCUTILS_RET_OK;
  } catch (const files::filesystem_error & error) {
    RCUTILS_SET_ERROR_MSG(error.what());
    return RCUTILS_RET_ERROR;
  }
}

rcutils_dir_iter_t * rcutils_dir_iter_start(const char * path, rcutils_allocator_t allocator)
{
  RCUTILS_CHECK_ARGUMENT_FOR_NULL(path, nullptr);
  RCUTILS_CHECK_ALLOCATOR_WITH_MSG(&allocator, "allocator is invalid", return nullptr);
  auto state = new rcutils_dir_iter_state_t{{".", ".."}};
  std::error_code why_not;
  for (files::directory_iterator entry(path, why_not), end; !why_not && entry != end; entry.increment(why_not)) {
    state->names.push_back(entry->path().filename().string());
  }
  void * place = why_not ? nullptr : allocator.allocate(sizeof(rcutils_dir_iter_t), allocator.state);
  if (!place) {
    delete state;
    RCUTILS_SET_ERROR_MSG_WITH_FORMAT_STRING("Can't open directory %s. Error: %s", path, why_not.message().c_str());
    return nullptr;
  }
  return new (place) rcutils_dir_iter_t{state->names[0].c_str(), allocator, state};
}
bool rcutils_dir_iter_next(rcutils_dir_iter_t * iter)
{
  RCUTILS_CHECK_ARGUMENT_FOR_NULL(iter, false);
  const auto & names = iter->state->names;
  const size_t next = ++iter->state->at;
  iter->entry_name = next < names.size() ? names[next].c_str() : nullptr;
  return iter->entry_name != nullptr;
}
void rcutils_dir_iter_end(rcutils_dir_iter_t * iter)
{
  if (iter) {
    delete iter->state;
    iter->allocator.deallocate(iter, iter->allocator.state);
  }
}
