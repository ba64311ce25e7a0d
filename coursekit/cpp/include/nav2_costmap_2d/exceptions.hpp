// What collision checkers throw.
#pragma once
#include <stdexcept>
#include <string>

namespace nav2_costmap_2d
{
class CollisionCheckerException : public std::runtime_error
{
public:
  explicit CollisionCheckerException(const std::string & description)
  : std::runtime_error(description) {}
};
}  // namespace nav2_costmap_2d
