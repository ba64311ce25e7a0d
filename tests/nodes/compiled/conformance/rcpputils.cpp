// What rcpputils does at its edges: names that are none, libraries that are not there, containers of all kinds.
#include <list>
#include <set>

#include "check.hpp"
#include "rcpputils/env.hpp"
#include "rcpputils/filesystem_helper.hpp"
#include "rcpputils/find_library.hpp"
#include "rcpputils/pointer_traits.hpp"
#include "rcpputils/scope_exit.hpp"
#include "rcpputils/shared_library.hpp"
#include "rcpputils/split.hpp"

static void variables()
{
  throws<std::runtime_error>("no variable without a name is read", [] {rcpputils::get_env_var(nullptr);});
  throws<std::runtime_error>("no variable without a name is set", [] {rcpputils::set_env_var(nullptr, "x");});
  throws<std::runtime_error>("no variable has = in its name", [] {rcpputils::set_env_var("a=b", "x");});
}

static void libraries()
{
  equal("a library's file", rcpputils::filename_for_library("maths"), "libmaths.so");
  equal("no path to a library that is not there", rcpputils::path_for_library("/nowhere", "maths"), "");
  throws<std::runtime_error>("a library's name has an end", [] {
      rcpputils::get_platform_library_name(std::string(1024, 'x'));
    });
  rcpputils::SharedLibrary maths("libm.so.6");
  maths.unload_library();
  throws<std::runtime_error>("a library goes once", [&] {maths.unload_library();});
  throws<std::runtime_error>("what has gone has no symbols", [&] {maths.get_symbol("cos");});
}

static void parts()
{
  std::list<std::string> words;
  auto end = std::back_inserter(words);
  rcpputils::split("left//right", '/', end);
  check("split into a list", words == std::list<std::string>{"left", "", "right"});
  std::set<std::string> kinds;
  auto place = std::inserter(kinds, kinds.end());
  rcpputils::split("b//a/b", '/', place, true);
  check("split into a set, without what is empty", kinds == std::set<std::string>{"a", "b"});
}

static void calls()
{
  int count = 0;
  {
    auto add = [&] {++count;};
    auto one = rcpputils::make_scope_exit(add);
    const auto add_two = [&] {count += 2;};
    auto two = rcpputils::make_scope_exit(add_two);
    auto moved = std::move(two);
    one.cancel();
  }
  equal("a named function is called at the block's end, once", count, 2);
}

static void pointers()
{
  using rcpputils::remove_pointer;
  check("pointed to by a constant pointer", std::is_same_v<remove_pointer<const int * const>::type, const int>);
  check(
    "pointed to by a volatile smart pointer",
    std::is_same_v<remove_pointer<const volatile std::shared_ptr<const int>>::type, const int>);
  check("pointed to by a reference to one", std::is_same_v<remove_pointer<std::unique_ptr<int> &>::type, int>);
  check("what is no pointer stays", std::is_same_v<remove_pointer<const int>::type, const int>);
}

static void folders()
{
  namespace fs = rcpputils::fs;
  fs::path folder = fs::create_temp_directory("");
  equal("a new folder without a name has six letters", folder.filename().string().size(), 6u);
  check("and goes", fs::remove(folder));
}

int main()
{
  variables();
  libraries();
  parts();
  calls();
  pointers();
  folders();
}
