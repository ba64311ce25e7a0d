// What finding a plugin, loading its library and making one may throw.
#pragma once
#include <stdexcept>

namespace pluginlib
{
class PluginlibException : public std::runtime_error {using std::runtime_error::runtime_error;};
class ClassLoaderException : public PluginlibException {using PluginlibException::PluginlibException;};
class InvalidXMLException : public PluginlibException {using PluginlibException::PluginlibException;};
class LibraryLoadException : public PluginlibException {using PluginlibException::PluginlibException;};
class LibraryUnloadException : public PluginlibException {using PluginlibException::PluginlibException;};
class CreateClassException : public PluginlibException {using PluginlibException::PluginlibException;};
class UniquePtrWarning : public PluginlibException {using PluginlibException::PluginlibException;};
}  // namespace pluginlib
