// Files and folders by the names that rcpputils gives them; std::filesystem does the work.
#pragma once
#include <filesystem>
#include <random>
#include <string>

namespace rcpputils::fs
{
class path
{
public:
  path() = default;
  path(const std::string & text)  // NOLINT: as Humble's, a text is a path
  : path_(text) {}
  path(const char * text)  // NOLINT
  : path_(text) {}
  std::string string() const {return path_.string();}
  bool exists() const {return std::filesystem::exists(path_);}
  bool is_directory() const noexcept {return std::filesystem::is_directory(path_);}
  bool is_regular_file() const noexcept {return std::filesystem::is_regular_file(path_);}
  uint64_t file_size() const {return std::filesystem::file_size(path_);}
  bool empty() const {return path_.empty();}
  bool is_absolute() const {return path_.is_absolute();}
  path parent_path() const {return path_.parent_path().string();}
  path filename() const {return path_.filename().string();}
  path extension() const {return path_.extension().string();}
  path stem() const {return path_.stem().string();}
  path operator/(const path & other) const {return (path_ / other.path_).string();}
  path & operator/=(const path & other)
  {
    path_ /= other.path_;
    return *this;
  }
  bool operator==(const path & other) const {return path_ == other.path_;}
  bool operator!=(const path & other) const {return path_ != other.path_;}

private:
  std::filesystem::path path_;
};
inline bool exists(const path & one) {return one.exists();}
inline bool is_directory(const path & one) noexcept {return one.is_directory();}
inline bool is_regular_file(const path & one) noexcept {return one.is_regular_file();}
inline uint64_t file_size(const path & one) {return one.file_size();}
inline path current_path() {return std::filesystem::current_path().string();}
inline path temp_directory_path() {return std::filesystem::temp_directory_path().string();}
inline bool create_directories(const path & one)
{
  std::filesystem::create_directories(one.string());
  return one.is_directory();
}
/// A new folder whose name nobody else has, such as base_Wk3b0Z.
inline path create_temp_directory(const std::string & base_name, const path & parent = temp_directory_path())
{
  static const char letters[] = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
  std::random_device chance;
  for (;;) {
    std::string name = base_name;
    for (int i = 0; i < 6; ++i) {
      name += letters[chance() % (sizeof(letters) - 1)];
    }
    path made = parent / name;
    if (std::filesystem::create_directories(made.string())) {
      return made;
    }
  }
}
inline bool remove(const path & one) {return std::filesystem::remove(one.string());}
inline bool remove_all(const path & one) {return std::filesystem::remove_all(one.string()) > 0;}
inline path remove_extension(const path & one, int times = 1)
{
  std::filesystem::path left(one.string());
  for (int i = 0; i < times; ++i) {
    left.replace_extension();
  }
  return left.string();
}
}  // namespace rcpputils::fs
