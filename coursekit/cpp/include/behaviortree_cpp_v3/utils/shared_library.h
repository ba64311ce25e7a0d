// A library that a program loads while it runs, and keeps.
#pragma once
#include <mutex>
#include <string>

namespace BT
{
class SharedLibrary
{
public:
  enum Flags
  {
    SHLIB_GLOBAL = 1,
    SHLIB_LOCAL = 2
  };

  SharedLibrary() = default;
  explicit SharedLibrary(const std::string & path, int flags = 0) {load(path, flags);}
  SharedLibrary(const SharedLibrary &) = delete;
  SharedLibrary & operator=(const SharedLibrary &) = delete;
  virtual ~SharedLibrary() = default;

  /// Load a file, or a library of a sourced workspace by the file's name alone. Throws RuntimeError.
  void load(const std::string & path, int flags = 0);
  void unload();
  bool isLoaded() const {return library_;}
  bool hasSymbol(const std::string & name);
  /// Throws RuntimeError where there is none.
  void * getSymbol(const std::string & name);
  const std::string & getPath() const {return path_;}

  static std::string prefix();
  static std::string suffix();
  static std::string getOSName(const std::string & name) {return prefix() + name + suffix();}

private:
  std::string path_;
  void * library_ = nullptr;
  std::mutex mutex_;
};
}  // namespace BT
