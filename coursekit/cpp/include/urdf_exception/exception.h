// What a description that is no robot throws.
#pragma once
#include <stdexcept>
#include <string>

namespace urdf
{
class ParseError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
}  // namespace urdf
