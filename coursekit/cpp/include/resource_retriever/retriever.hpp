// Files by their addresses: package:// and file://.
#pragma once
#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>

#include "ament_index_cpp/get_package_share_directory.hpp"

namespace resource_retriever
{
class Exception : public std::runtime_error
{
public:
  Exception(const std::string & file, const std::string & error_msg)
  : std::runtime_error("Error retrieving file [" + file + "]: " + error_msg) {}
};

/// A file's content.
struct MemoryResource
{
  std::shared_ptr<uint8_t> data;
  size_t size = 0;
};

class Retriever
{
public:
  Retriever() = default;
  Retriever(const Retriever &) = delete;
  Retriever & operator=(const Retriever &) = delete;
  Retriever(Retriever &&) noexcept = default;
  Retriever & operator=(Retriever &&) noexcept = default;

  /// The content of a file. Exception where there is none, or where its address begins in another way.
  MemoryResource get(const std::string & url)
  {
    const std::string path = path_of(url);
    std::ifstream file(path, std::ios::binary);
    if (!file) {
      throw Exception(url, "Couldn't open file " + path);
    }
    const std::string content((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    MemoryResource resource;
    if (!content.empty()) {
      resource.size = content.size();
      resource.data.reset(new uint8_t[resource.size], std::default_delete<uint8_t[]>());
      std::copy(content.begin(), content.end(), resource.data.get());
    }
    return resource;
  }

private:
  static bool begins(const std::string & url, const char * with) {return url.rfind(with, 0) == 0;}
  static std::string path_of(const std::string & url)
  {
    if (begins(url, "package://")) {
      return path_in_package(url, url.substr(10));
    }
    if (begins(url, "file:///")) {
      return decoded(url.substr(7));
    }
    throw Exception(url, "Only package://NAME/PATH and file:///PATH are read here: download it to a file first");
  }
  static std::string path_in_package(const std::string & url, const std::string & rest)
  {
    const size_t slash = rest.find('/');
    if (slash == std::string::npos) {
      throw Exception(url, "Could not parse package:// format into file:// format");
    }
    const std::string package = rest.substr(0, slash);
    if (package.empty()) {
      throw Exception(url, "Package name must not be empty");
    }
    try {
      return ament_index_cpp::get_package_share_directory(package) + decoded(rest.substr(slash));
    } catch (const ament_index_cpp::PackageNotFoundError &) {
      throw Exception(url, "Package [" + package + "] does not exist");
    }
  }
  /// A path of an address, in which %20 is a space.
  static std::string decoded(const std::string & path)
  {
    std::string plain;
    for (size_t at = 0; at < path.size(); ++at) {
      if (path[at] == '%' && at + 2 < path.size() && isxdigit(path[at + 1]) && isxdigit(path[at + 2])) {
        plain += static_cast<char>(std::stoi(path.substr(at + 1, 2), nullptr, 16));
        at += 2;
      } else {
        plain += path[at];
      }
    }
    return plain;
  }
};
}  // namespace resource_retriever
