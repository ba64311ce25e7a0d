// Files and folders by the names that rcpputils gives them.
#include <filesystem>
#include <ostream>
#include <random>

#include "rclcpp/logger.hpp"
#include "rcpputils/env.hpp"
#include "rcpputils/filesystem_helper.hpp"

namespace files = std::filesystem;

namespace rcpputils::fs
{
path::path(const std::string & text)
: text_(text)
{
  for (char & c : text_) {
    c = c == '/' || c == '\\' ? kPreferredSeparator : c;
  }
  for (const auto & part : files::path(text_)) {
    parts_.push_back(part.string());
  }
}
bool path::exists() const {return files::exists(text_);}
bool path::is_directory() const noexcept
{
  std::error_code why_not;
  return files::is_directory(text_, why_not);
}
bool path::is_regular_file() const noexcept
{
  std::error_code why_not;
  return files::is_regular_file(text_, why_not);
}
uint64_t path::file_size() const {return files::file_size(text_);}
bool path::is_absolute() const {return files::path(text_).is_absolute();}
path path::parent_path() const
{
  std::string parent = files::path(text_).parent_path().string();
  return parent.empty() && !text_.empty() ? "." : parent;
}
path path::filename() const {return files::path(text_).filename().string();}
path path::extension() const {return files::path(text_).extension().string();}
path path::stem() const {return files::path(text_).stem().string();}
path path::operator/(const path & other) const {return (files::path(text_) / other.text_).string();}
bool path::operator==(const path & other) const {return files::path(text_) == files::path(other.text_);}
std::ostream & operator<<(std::ostream & stream, const path & one) {return stream << one.string();}

path current_path() {return files::current_path().string();}
path temp_directory_path() {return files::temp_directory_path().string();}
bool create_directories(const path & one)
{
  std::error_code why_not;
  files::create_directories(one.string(), why_not);
  return one.is_directory();
}
path create_temp_directory(const std::string & base_name, const path & parent)
{
  static const char letters[] = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
  files::create_directories(parent.string());  // std::system_error where it cannot be
  std::random_device chance;
  for (;;) {
    std::string name = base_name;
    for (int i = 0; i < 6; ++i) {
      name += letters[chance() % (sizeof(letters) - 1)];
    }
    path made = parent / name;
    if (files::create_directory(made.string())) {
      return made;
    }
  }
}
bool remove(const path & one)
{
  std::error_code why_not;
  return files::remove(one.string(), why_not);
}
bool remove_all(const path & one)
{
  std::error_code why_not;
  auto removed = files::remove_all(one.string(), why_not);
  return !why_not && removed > 0;
}
path remove_extension(const path & one, int times)
{
  files::path left(one.string());
  for (int i = 0; i < times; ++i) {
    left.replace_extension();
  }
  return left.string();
}
}  // namespace rcpputils::fs

rcpputils::fs::path rclcpp::get_logging_directory()
{
  using rcpputils::get_env_var;
  std::string own = get_env_var("ROS_LOG_DIR"), home = get_env_var("ROS_HOME");
  if (!own.empty()) {
    return own;
  }
#ifdef _WIN32
  std::string user = get_env_var("USERPROFILE");
#else
  std::string user = get_env_var("HOME");
#endif
  return (home.empty() ? rcpputils::fs::path(user) / ".ros" : rcpputils::fs::path(home)) / "log";
}
