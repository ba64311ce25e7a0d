// Which threads are a library's own.
#include "pools.hpp"

#include <dlfcn.h>

#include <array>
#include <atomic>
#include <string>

namespace coursekit
{
namespace
{
/// Where those libraries begin in memory; the first null ends them.
std::array<std::atomic<const void *>, 16> pools{};

/// What is in these belongs to whoever calls them.
constexpr const char * WRAPPERS[] = {
  "/libstdc++.", "/libc++.", "/libc.so", "/libc-", "/libpthread", "/libboost_thread", "/libsystem_"};
constexpr const char * FOLDERS[] = {"/lib/", "/lib64/", "/usr/lib/", "/usr/lib64/", "/usr/local/lib/", "/opt/homebrew/"};

bool is_of_system(const std::string & path)
{
  for (const char * folder : FOLDERS) {
    if (path.rfind(folder, 0) == 0) {
      return true;
    }
  }
  return false;
}
bool is_wrapper(const std::string & path)
{
  for (const char * name : WRAPPERS) {
    if (path.find(name) != std::string::npos) {
      return true;
    }
  }
  return false;
}
void remember(const void * base)
{
  for (auto & pool : pools) {
    const void * none = nullptr;
    if (pool == base || pool.compare_exchange_strong(none, base) || none == base) {
      return;
    }
  }
}
}  // namespace

thread_local bool t_in_pool = false;

bool starts_pool(void * (*function)(void *), void * argument)
{
  Dl_info found;
  if (!dladdr(reinterpret_cast<void *>(function), &found) || !found.dli_fname) {
    return false;
  }
  if (std::string(found.dli_fname).find("/libstdc++.") != std::string::npos) {  // std::thread: the table of what it runs
    const void * table = argument ? *static_cast<const void * const *>(argument) : nullptr;
    if (!table || !dladdr(table, &found) || !found.dli_fname) {
      return false;
    }
  }
  if (!is_of_system(found.dli_fname) || is_wrapper(found.dli_fname)) {
    return false;
  }
  remember(found.dli_fbase);
  return true;
}
bool is_of_pool(const void * code)
{
  Dl_info found;
  if (!pools[0] || !dladdr(code, &found)) {
    return false;
  }
  for (auto & pool : pools) {
    if (!pool || pool == found.dli_fbase) {
      return pool != nullptr;
    }
  }
  return false;
}
}  // namespace coursekit
