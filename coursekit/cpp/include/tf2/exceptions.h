// What tf2 throws.
#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>

namespace tf2
{
enum class TF2Error : std::uint8_t
{
  TF2_NO_ERROR = 0, TF2_LOOKUP_ERROR = 1, TF2_CONNECTIVITY_ERROR = 2, TF2_EXTRAPOLATION_ERROR = 3,
  TF2_INVALID_ARGUMENT_ERROR = 4, TF2_TIMEOUT_ERROR = 5, TF2_TRANSFORM_ERROR = 6, TF2_BACKWARD_EXTRAPOLATION_ERROR = 7,
  TF2_FORWARD_EXTRAPOLATION_ERROR = 8, TF2_NO_DATA_FOR_EXTRAPOLATION_ERROR = 9
};

class TransformException : public std::runtime_error
{
public:
  explicit TransformException(const std::string & text)
  : std::runtime_error(text) {}
};
#define COURSEKIT_TF2_EXCEPTION(Name, Base) \
  class Name : public Base \
  { \
  public: \
    explicit Name(const std::string & text) \
    : Base(text) {} \
  };
COURSEKIT_TF2_EXCEPTION(ConnectivityException, TransformException)
COURSEKIT_TF2_EXCEPTION(LookupException, TransformException)
COURSEKIT_TF2_EXCEPTION(ExtrapolationException, TransformException)
COURSEKIT_TF2_EXCEPTION(InvalidArgumentException, TransformException)
COURSEKIT_TF2_EXCEPTION(TimeoutException, TransformException)
COURSEKIT_TF2_EXCEPTION(BackwardExtrapolationException, ExtrapolationException)
COURSEKIT_TF2_EXCEPTION(ForwardExtrapolationException, ExtrapolationException)
COURSEKIT_TF2_EXCEPTION(NoDataForExtrapolationException, ExtrapolationException)
}  // namespace tf2
