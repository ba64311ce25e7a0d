// How the values of a blackboard cross to bt_navigator's, which is in Python, and back.
#pragma once
#include <string>
#include <utility>

#include "behaviortree_cpp_v3/blackboard.h"

namespace BT
{
/// Set a value that came with the name of its type; nothing for a type that is not known here.
void put(Blackboard & board, const std::string & key, const std::string & type, const std::string & bytes);
/// The name of a value's type and the value; an empty name for what stays here.
std::pair<std::string, std::string> packed(const Any & value);
}  // namespace BT
