// The latest message of each topic, with each message of the topic that comes most often.
#pragma once
#include <algorithm>
#include <array>
#include <mutex>

#include "message_filters/synchronizer.h"
#include "rclcpp/clock.hpp"

namespace message_filters::sync_policies
{
/// Topics need not have the same rate: the one with the highest is the pivot, and each of its messages makes a set with
/// the last ones of the others. Rates are those at which messages arrive, averaged.
template<class ... M>
class LatestTime : public PolicyBase<M...>
{
public:
  LatestTime()
  : LatestTime(std::make_shared<rclcpp::Clock>(RCL_ROS_TIME)) {}
  explicit LatestTime(rclcpp::Clock::SharedPtr clock)
  : clock_(std::move(clock)) {}
  LatestTime(const LatestTime & other)
  : PolicyBase<M...>(other), clock_(other.clock_), latest_(other.latest_), rates_(other.rates_), pivot_(other.pivot_) {}

protected:
  void take(size_t which, const Stamped & one)
  {
    std::vector<Stamped> set;
    {
      std::lock_guard<std::mutex> hold(lock_);
      latest_[which] = one;
      rates_[which].count(clock_->now().nanoseconds());
      bool complete = std::all_of(latest_.begin(), latest_.end(), [](auto & part) {return part.message != nullptr;});
      if (complete && which == pivot()) {
        set.assign(latest_.begin(), latest_.end());
      }
    }
    if (!set.empty()) {
      this->signal(set);
    }
  }

private:
  /// How often messages come, per second: the mean of what is between them, the latest counting most.
  struct Rate
  {
    void count(int64_t now)
    {
      if (before_ && now > before_) {
        double fresh = 1e9 / static_cast<double>(now - before_);
        value = value > 0.0 ? (1.0 - WEIGHT) * value + WEIGHT * fresh : fresh;
      }
      before_ = now;
    }
    static constexpr double WEIGHT = 0.1;
    double value = 0.0;

private:
    int64_t before_ = 0;
  };
  /// The topic with the highest rate; another one takes its place only where it is clearly faster.
  size_t pivot()
  {
    for (size_t i = 0; i < sizeof...(M); ++i) {
      if (rates_[i].value > MARGIN * rates_[pivot_].value) {
        pivot_ = i;
      }
    }
    return pivot_;
  }
  static constexpr double MARGIN = 1.1;
  rclcpp::Clock::SharedPtr clock_;
  std::mutex lock_;
  std::array<Stamped, sizeof...(M)> latest_{};
  std::array<Rate, sizeof...(M)> rates_{};
  size_t pivot_ = 0;
};
}  // namespace message_filters::sync_policies
