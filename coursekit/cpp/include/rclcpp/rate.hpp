// Loops at a rate.
#pragma once
#include <chrono>

#include "rclcpp/clock.hpp"
#include "rclcpp/utilities.hpp"

namespace rclcpp
{
class RateBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(RateBase)
  virtual ~RateBase() = default;
  virtual bool sleep() = 0;
  virtual bool is_steady() const = 0;
  virtual void reset() = 0;
};

template<class Clock = std::chrono::high_resolution_clock>
class GenericRate : public RateBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericRate)
  explicit GenericRate(double rate)
  : GenericRate(std::chrono::nanoseconds(static_cast<int64_t>(1e9 / rate))) {}
  explicit GenericRate(std::chrono::nanoseconds period)
  : period_(period), last_interval_(Clock::now()) {}

  /// Sleep until the next interval begins; false at once where it has begun already.
  bool sleep() override
  {
    auto now = Clock::now();
    auto next = last_interval_ + period_;
    if (now < last_interval_) {
      next = now + period_;
    }
    last_interval_ += period_;
    if (next <= now) {
      if (now > next + period_) {
        last_interval_ = now + period_;
      }
      return false;
    }
    rclcpp::sleep_for(std::chrono::duration_cast<std::chrono::nanoseconds>(next - now));
    return true;
  }
  bool is_steady() const override {return Clock::is_steady;}
  void reset() override {last_interval_ = Clock::now();}
  std::chrono::nanoseconds period() const {return period_;}

private:
  std::chrono::nanoseconds period_;
  std::chrono::time_point<Clock, std::chrono::nanoseconds> last_interval_;
};
using Rate = GenericRate<std::chrono::system_clock>;
using WallRate = GenericRate<std::chrono::steady_clock>;
}  // namespace rclcpp
