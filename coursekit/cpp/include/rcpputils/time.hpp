// Durations of all kinds as nanoseconds.
#pragma once
#include <chrono>
#include <stdexcept>

namespace rcpputils
{
/// The duration in nanoseconds; std::invalid_argument where an int64_t cannot hold it.
template<class Rep, class Period>
std::chrono::nanoseconds convert_to_nanoseconds(const std::chrono::duration<Rep, Period> & time)
{
  constexpr auto most = std::chrono::duration<long double, std::nano>(std::chrono::nanoseconds::max());
  constexpr auto least = std::chrono::duration<long double, std::nano>(std::chrono::nanoseconds::min());
  auto wide = std::chrono::duration<long double, std::nano>(time);
  if (wide > most || wide < least) {
    throw std::invalid_argument("time must be less than max of std::chrono::nanoseconds");
  }
  return std::chrono::duration_cast<std::chrono::nanoseconds>(time);
}
}  // namespace rcpputils
