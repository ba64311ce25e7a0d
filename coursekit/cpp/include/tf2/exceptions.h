// What tf2 throws.
#pragma once
#include <stdexcept>
#include <string>

namespace tf2
{
class TransformException : public std::runtime_error
{
public:
  explicit TransformException(const std::string & text)
  : std::runtime_error(text) {}
};
#define COURSEKIT_TF2_EXCEPTION(Name) \
  class Name : public TransformException \
  { \
  public: \
    explicit Name(const std::string & text) \
    : TransformException(text) {} \
  };
COURSEKIT_TF2_EXCEPTION(ConnectivityException)
COURSEKIT_TF2_EXCEPTION(LookupException)
COURSEKIT_TF2_EXCEPTION(ExtrapolationException)
COURSEKIT_TF2_EXCEPTION(InvalidArgumentException)
COURSEKIT_TF2_EXCEPTION(TimeoutException)
}  // namespace tf2
