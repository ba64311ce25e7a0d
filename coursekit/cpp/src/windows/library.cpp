// Libraries that a program loads while it runs, and the program's own file.
#include <windows.h>

#include "../system.hpp"

namespace coursekit
{
void * load_library(const std::string & path, std::string & reason)
{
  int units = MultiByteToWideChar(CP_UTF8, 0, path.c_str(), -1, nullptr, 0);
  std::wstring wide(static_cast<size_t>(units), L'\0');
  MultiByteToWideChar(CP_UTF8, 0, path.c_str(), -1, &wide[0], units);
  HMODULE library = LoadLibraryW(wide.c_str());
  if (!library) {
    reason = "error " + std::to_string(GetLastError()) + " of Windows";
  }
  return reinterpret_cast<void *>(library);
}
void * symbol_of(void * library, const std::string & name)
{
  return reinterpret_cast<void *>(GetProcAddress(static_cast<HMODULE>(library), name.c_str()));
}
void unload_library(void * library) {FreeLibrary(static_cast<HMODULE>(library));}
std::string executable()
{
  wchar_t wide[4096];
  DWORD units = GetModuleFileNameW(nullptr, wide, 4096);
  char path[3 * 4096];
  int size = WideCharToMultiByte(CP_UTF8, 0, wide, static_cast<int>(units), path, sizeof(path), nullptr, nullptr);
  return std::string(path, static_cast<size_t>(size));
}
}  // namespace coursekit
