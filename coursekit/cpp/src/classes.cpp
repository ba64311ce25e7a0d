// The classes that this program and the libraries it has loaded have.
#include <fstream>
#include <iterator>
#include <map>
#include <mutex>
#include <utility>

#include "ament_index_cpp/get_package_prefix.hpp"
#include "class_loader/exceptions.hpp"
#include "class_loader/registry.hpp"
#include "state.hpp"

namespace class_loader::registry
{
namespace
{
struct Known
{
  std::recursive_mutex lock;
  std::map<std::string, std::map<std::string, std::map<std::string, Maker>>> makers;  // by library, base and name
  std::map<std::string, void *> loaded;
  std::string loading;
};
Known & known()
{
  static Known * all = new Known;  // never destroyed: libraries may still enter what they have
  return *all;
}
/// Where a library is that is told by its name alone: in the first sourced workspace that has it.
std::string found(const std::string & path)
{
  if (path.find('/') == std::string::npos) {
    for (auto & prefix : ament_index_cpp::get_search_paths()) {
      struct stat there;
      std::string whole = prefix + "/lib/" + path;
      if (stat(whole.c_str(), &there) == 0) {
        return whole;
      }
    }
  }
  return path;
}
/// Whether it was built here for another runtime than this one; a library of the system's does not say.
bool is_of_another_age(const std::string & path)
{
  const std::string own = coursekit::age(), mark = own.substr(0, own.find(':') + 1);
  std::ifstream file(path, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  const size_t at = bytes.find(mark);
  return at != bytes.npos && bytes.compare(at, own.size(), own) != 0;
}
}  // namespace

bool enter(const std::string & base, const std::string & name, Maker maker)
{
  std::lock_guard<std::recursive_mutex> hold(known().lock);
  return known().makers[known().loading][base].emplace(name, std::move(maker)).second;
}
void * load(const std::string & path)
{
  std::lock_guard<std::recursive_mutex> hold(known().lock);
  if (path.empty() || known().loaded.count(path)) {
    return path.empty() ? nullptr : known().loaded[path];
  }
  const std::string file = found(path);
  if (is_of_another_age(file)) {
    throw LibraryLoadException(
            "Could not load library " + path + ": it was built by another version of coursekit than this program. Build its "
            "workspace again: `colcon build`.");
  }
  std::string before = std::exchange(known().loading, path);
  std::string reason;
  void * library = coursekit::load_library(file, reason);
  known().loading = before;
  if (!library) {
    throw LibraryLoadException("Could not load library " + path + ": " + reason);
  }
  return known().loaded[path] = library;
}
std::vector<std::string> names(const std::string & base, const std::string & library)
{
  std::lock_guard<std::recursive_mutex> hold(known().lock);
  std::vector<std::string> all;
  for (auto & entry : known().makers[library][base]) {
    all.push_back(entry.first);
  }
  return all;
}
Maker maker(const std::string & base, const std::string & name, const std::string & library)
{
  std::lock_guard<std::recursive_mutex> hold(known().lock);
  auto & makers = known().makers[library][base];
  auto found = makers.find(name);
  return found == makers.end() ? Maker() : found->second;
}
}  // namespace class_loader::registry
