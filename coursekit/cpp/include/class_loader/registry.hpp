// The classes that a program and the libraries it has loaded have entered, by their base class and their name.
#pragma once
#include <functional>
#include <string>
#include <typeinfo>
#include <vector>

namespace class_loader::registry
{
/// Makes an object: a pointer to its base class.
using Maker = std::function<void * ()>;

/// Enter a class of the library that is loading, or of the program itself, whose library is "".
bool enter(const std::string & base, const std::string & name, Maker maker);
/// Load a library's code, once, and return the system's handle of it. Throws LibraryLoadException.
void * load(const std::string & path);
/// The names of the classes of a base class that a library entered, sorted.
std::vector<std::string> names(const std::string & base, const std::string & library);
/// What makes a class of a library; an empty function where there is none.
Maker maker(const std::string & base, const std::string & name, const std::string & library);

template<class Base>
std::string key() {return typeid(Base).name();}
template<class Derived, class Base>
bool enter_class(const std::string & name)
{
  return enter(key<Base>(), name, [] {return static_cast<void *>(static_cast<Base *>(new Derived));});
}
}  // namespace class_loader::registry
