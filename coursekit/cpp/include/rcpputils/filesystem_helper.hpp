// Files and folders by the names that rcpputils gives them; the runtime does the work, with std::filesystem.
#pragma once
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace rcpputils::fs
{
static constexpr const char kPreferredSeparator =
#ifdef _WIN32
  '\\';
#else
  '/';
#endif

class path
{
public:
  path() = default;
  path(const std::string & text);  // NOLINT: as Humble's, a text is a path
  path(const char * text)  // NOLINT
  : path(std::string(text)) {}
  std::string string() const {return text_;}
  bool exists() const;
  bool is_directory() const noexcept;
  bool is_regular_file() const noexcept;
  uint64_t file_size() const;
  bool empty() const {return text_.empty();}
  bool is_absolute() const;
  /// Its parts, one after the other.
  std::vector<std::string>::const_iterator cbegin() const {return parts_.cbegin();}
  std::vector<std::string>::const_iterator cend() const {return parts_.cend();}
  path parent_path() const;
  path filename() const;
  path extension() const;
  path stem() const;
  path operator/(const path & other) const;
  path & operator/=(const path & other) {return *this = *this / other;}
  bool operator==(const path & other) const;
  bool operator!=(const path & other) const {return !(*this == other);}

private:
  std::string text_;
  std::vector<std::string> parts_;
};
std::ostream & operator<<(std::ostream & stream, const path & one);

inline bool exists(const path & one) {return one.exists();}
inline bool is_directory(const path & one) noexcept {return one.is_directory();}
inline bool is_regular_file(const path & one) noexcept {return one.is_regular_file();}
inline uint64_t file_size(const path & one) {return one.file_size();}
path current_path();
path temp_directory_path();
/// Make a folder and those above it; whether it is there.
bool create_directories(const path & one);
/// A new folder whose name nobody else has, such as base_Wk3b0Z.
path create_temp_directory(const std::string & base_name, const path & parent = temp_directory_path());
bool remove(const path & one);
bool remove_all(const path & one);
path remove_extension(const path & one, int times = 1);
}  // namespace rcpputils::fs
