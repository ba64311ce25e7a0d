// Reads descriptions of trees, and says what is wrong with them.
#pragma once
#include <filesystem>
#include <string>
#include <unordered_map>

#include "behaviortree_cpp_v3/basic_types.h"
#include "xml.hpp"

namespace BT::description
{
using coursekit::xml::Element;
using Types = std::unordered_map<std::string, NodeType>;

/// All of them throw RuntimeError, with the line.
[[noreturn]] void fail(const Element & at, const std::string & why);
Element read(const std::string & text);
Element read_file(const std::filesystem::path & path);
void verify(const Element & root, const Types & types);

/// Whether it stands for a node whose name is its ID.
bool is_explicit(const std::string & name);
}  // namespace BT::description
