// Mean, deviation and extremes of numbers that come one after the other, without keeping them.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <sstream>
#include <string>

namespace libstatistics_collector::moving_average_statistics
{
/// NaN for all but the count where nothing was measured.
struct StatisticData
{
  double average = std::nan(""), min = std::nan(""), max = std::nan(""), standard_deviation = std::nan("");
  uint64_t sample_count = 0;
};
inline std::string StatisticsDataToString(const StatisticData & of)
{
  std::stringstream text;
  text << "avg=" << of.average << ", min=" << of.min << ", max=" << of.max << ", std_dev=" << of.standard_deviation <<
    ", count=" << of.sample_count;
  return text.str();
}

class MovingAverageStatistics
{
public:
  virtual ~MovingAverageStatistics() = default;
  double Average() const {return GetStatistics().average;}
  double Max() const {return GetStatistics().max;}
  double Min() const {return GetStatistics().min;}
  double StandardDeviation() const {return GetStatistics().standard_deviation;}
  uint64_t GetCount() const {return GetStatistics().sample_count;}
  StatisticData GetStatistics() const
  {
    std::lock_guard<std::mutex> hold(lock_);
    StatisticData made;
    if (count_) {
      made = {average_, min_, max_, std::sqrt(squares_ / static_cast<double>(count_)), count_};
    }
    return made;
  }
  void Reset()
  {
    std::lock_guard<std::mutex> hold(lock_);
    average_ = squares_ = 0;
    min_ = std::numeric_limits<double>::max();
    max_ = std::numeric_limits<double>::lowest();
    count_ = 0;
  }
  /// Count a number in; one that is none is left out.
  virtual void AddMeasurement(const double item)
  {
    std::lock_guard<std::mutex> hold(lock_);
    if (!std::isfinite(item)) {
      return;
    }
    const double before = average_;
    average_ += (item - before) / static_cast<double>(++count_);
    squares_ += (item - before) * (item - average_);  // Welford's way, which loses no digits
    min_ = std::min(min_, item);
    max_ = std::max(max_, item);
  }

private:
  mutable std::mutex lock_;
  double average_ = 0, squares_ = 0, min_ = std::numeric_limits<double>::max(), max_ = std::numeric_limits<double>::lowest();
  uint64_t count_ = 0;
};
}  // namespace libstatistics_collector::moving_average_statistics
