// The names of types as a program writes them.
#pragma once
#include <string>
#include <typeinfo>

namespace BT
{
std::string demangle(const std::type_info & type);
/// "void" for no type.
std::string demangle(const std::type_info * type);
}  // namespace BT
