// Files, folders and libraries in C.
#include <fstream>
#include <set>

#include "check.hpp"
#include "rcpputils/filesystem_helper.hpp"
#include "rcutils/error_handling.h"
#include "rcutils/filesystem.h"
#include "rcutils/shared_library.h"

static void files()
{
  auto allocator = rcutils_get_default_allocator();
  auto folder = rcpputils::fs::create_temp_directory("probe");
  rcpputils::fs::create_directories(folder / "deep");
  std::ofstream((folder / "a").string()) << "four";
  std::ofstream((folder / "deep" / "b").string()) << "sixsix";
  uint64_t size = 0;
  (void)rcutils_calculate_directory_size(folder.string().c_str(), &size, allocator);
  equal("a folder's own files", size, 4u);
  (void)rcutils_calculate_directory_size_with_recursion(folder.string().c_str(), 0, &size, allocator);
  equal("with all below it", size, 10u);
  (void)rcutils_calculate_directory_size_with_recursion(folder.string().c_str(), 1, &size, allocator);
  equal("to one level", size, 4u);
  equal("no folder", rcutils_calculate_directory_size("/nowhere", &size, allocator), RCUTILS_RET_ERROR);
  check("may be read and written", rcutils_is_readable_and_writable(folder.string().c_str()));
  check("what is not there may not", !rcutils_is_readable("/nowhere") && !rcutils_is_writable("/nowhere"));
  std::string inside = (folder / "new" / "newer").string();
  check("one folder is made at a time", !rcutils_mkdir(inside.c_str()));
  rcutils_dir_iter_t * entries = rcutils_dir_iter_start(folder.string().c_str(), allocator);
  std::set<std::string> names;
  for (bool more = entries != nullptr; more; more = rcutils_dir_iter_next(entries)) {
    names.insert(entries->entry_name);
  }
  rcutils_dir_iter_end(entries);
  check("what a folder has", names == std::set<std::string>{".", "..", "a", "deep"});
  rcpputils::fs::remove_all(folder);

  char * home = rcutils_expand_user("~/map", allocator);
  equal("the user's home", std::string(home), std::string(rcutils_get_home_dir()) + "/map");
  allocator.deallocate(home, allocator.state);
  char * path = rcutils_to_native_path("a/b", allocator);
  equal("a path as the system has it", std::string(path), "a/b");
  allocator.deallocate(path, allocator.state);
}

static void libraries()
{
  auto allocator = rcutils_get_default_allocator();
  auto library = rcutils_get_zero_initialized_shared_library();
  char name[32];
  check("a library's name in C", !rcutils_get_platform_library_name("m", name, sizeof name, true) && name == std::string("libmd.so"));
  equal("a name has room or is none", rcutils_get_platform_library_name("maths", name, 8, false), RCUTILS_RET_ERROR);
  equal("no library, an error", rcutils_load_shared_library(&library, "libnowhere.so", allocator), RCUTILS_RET_ERROR);
  equal("a library is loaded", rcutils_load_shared_library(&library, "libm.so.6", allocator), RCUTILS_RET_OK);
  check("and has symbols", rcutils_is_shared_library_loaded(&library) && rcutils_has_symbol(&library, "cos"));
  check("but not all", rcutils_get_symbol(&library, "no_such_symbol") == nullptr);
  equal("not twice in one place", rcutils_load_shared_library(&library, "libm.so.6", allocator), RCUTILS_RET_INVALID_ARGUMENT);
  equal("it is unloaded", rcutils_unload_shared_library(&library), RCUTILS_RET_OK);
  equal("once", rcutils_unload_shared_library(&library), RCUTILS_RET_INVALID_ARGUMENT);
  rcutils_reset_error();
}

int main()
{
  files();
  libraries();
}
