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
class LatestTime : public PolicyOf<LatestTime<M...>, M...>
{
  using Base = PolicyOf<LatestTime, M...>;
  friend Base;

public:
  LatestTime()
  : LatestTime(std::make_shared<rclcpp::Clock>(RCL_ROS_TIME)) {}
  explicit LatestTime(rclcpp::Clock::SharedPtr clock)
  : clock_(std::move(clock)) {}
  LatestTime(const LatestTime & other)
  : Base(other), clock_(other.clock_), latest_(other.latest_), rates_(other.rates_), pivot_(other.pivot_) {}

  /// The clock of the rates.
  void setClock(rclcpp::Clock::SharedPtr clock) {clock_ = std::move(clock);}

protected:
  template<class Event>
  static int64_t stamp_of(const Event &) {return 0;}
  void take(size_t which, const Stamped & one)
  {
    std::vector<Stamped> set;
    {
      std::lock_guard<std::mutex> hold(lock_);
      latest_[which] = one;
      const int64_t now = clock_->now().nanoseconds();
      rates_[which].count(now);
      bool complete = std::all_of(latest_.begin(), latest_.end(), [](auto & part) {return part.message != nullptr;});
      if (complete && rates_[which].value > 0.0 && which == pivot(now)) {
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
        bool as_before = fresh < STEP * value && value < STEP * fresh;
        value = as_before ? (1.0 - WEIGHT) * value + WEIGHT * fresh : fresh;
      }
      before_ = now;
    }
    /// Whether a message should have come since the last one.
    bool is_late(int64_t now) const {return value > 0.0 && static_cast<double>(now - before_) * value > STEP * 1e9;}
    static constexpr double WEIGHT = 0.1;
    /// What differs by more than this factor is another rate, not a rate that varies.
    static constexpr double STEP = 1.5;
    double value = 0.0;

private:
    int64_t before_ = 0;
  };
  /// The topic with the highest rate of those that are not late; another one takes its place only where it is clearly faster.
  size_t pivot(int64_t now)
  {
    for (size_t i = 0; i < sizeof...(M); ++i) {
      double least = rates_[pivot_].is_late(now) ? 0.0 : MARGIN * rates_[pivot_].value;
      if (!rates_[i].is_late(now) && rates_[i].value > least) {
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
