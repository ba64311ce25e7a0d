// What loading a library and making an object of one of its classes may throw.
#pragma once
#include <stdexcept>
#include <string>

namespace class_loader
{
class ClassLoaderException : public std::runtime_error {using std::runtime_error::runtime_error;};
class LibraryLoadException : public ClassLoaderException {using ClassLoaderException::ClassLoaderException;};
class LibraryUnloadException : public ClassLoaderException {using ClassLoaderException::ClassLoaderException;};
class CreateClassException : public ClassLoaderException {using ClassLoaderException::ClassLoaderException;};
class NoClassLoaderExistsException : public ClassLoaderException {using ClassLoaderException::ClassLoaderException;};
}  // namespace class_loader
