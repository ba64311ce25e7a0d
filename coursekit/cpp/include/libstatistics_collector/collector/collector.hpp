// What collects the numbers of one metric, between a start and a stop.
#pragma once
#include "libstatistics_collector/moving_average_statistics/moving_average.hpp"

namespace libstatistics_collector::collector
{
class MetricDetailsInterface
{
public:
  virtual ~MetricDetailsInterface() = default;
  virtual std::string GetMetricName() const = 0;
  virtual std::string GetMetricUnit() const = 0;
};

class Collector : public MetricDetailsInterface
{
public:
  virtual void AcceptData(const double measurement) {data_.AddMeasurement(measurement);}
  virtual moving_average_statistics::StatisticData GetStatisticsResults() const {return data_.GetStatistics();}
  virtual void ClearCurrentMeasurements() {data_.Reset();}
  bool IsStarted() const
  {
    std::lock_guard<std::mutex> hold(lock_);
    return started_;
  }
  virtual std::string GetStatusString() const
  {
    return "name=" + GetMetricName() + ", unit=" + GetMetricUnit() + ", started=" + (IsStarted() ? "true" : "false") + ", " +
           moving_average_statistics::StatisticsDataToString(GetStatisticsResults());
  }
  /// Start it; false where it has been started, or its own start fails.
  virtual bool Start()
  {
    std::lock_guard<std::mutex> hold(lock_);
    if (started_) {
      return false;
    }
    started_ = true;
    return SetupStart();
  }
  /// Stop it, and forget what was measured; false where it has not been started, or its own stop fails.
  virtual bool Stop()
  {
    std::lock_guard<std::mutex> hold(lock_);
    if (!started_) {
      return false;
    }
    started_ = false;
    ClearCurrentMeasurements();
    return SetupStop();
  }

private:
  virtual bool SetupStart() = 0;
  virtual bool SetupStop() = 0;
  mutable std::mutex lock_;
  moving_average_statistics::MovingAverageStatistics data_;
  bool started_ = false;
};
}  // namespace libstatistics_collector::collector
