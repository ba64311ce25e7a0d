// Tasks about how often and how late something happens.
#pragma once
#include <cmath>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "diagnostic_updater/diagnostic_updater.hpp"

namespace diagnostic_updater
{
/// Bounds of a frequency [Hz], which may change later; by how much they may be missed (0.1: a tenth), over how many reports.
struct FrequencyStatusParam
{
  FrequencyStatusParam(double * min_freq, double * max_freq, double tolerance = 0.1, int window_size = 5)
  : min_freq_(min_freq), max_freq_(max_freq), tolerance_(tolerance), window_size_(window_size) {}
  double lowest() const {return *min_freq_ * (1 - tolerance_);}
  double highest() const {return *max_freq_ * (1 + tolerance_);}

  double * min_freq_;
  double * max_freq_;
  double tolerance_;
  int window_size_;
};

/// How often `tick` was called.
class FrequencyStatus : public DiagnosticTask
{
public:
  FrequencyStatus(
    const FrequencyStatusParam & params, std::string name,
    const rclcpp::Clock::SharedPtr & clock = std::make_shared<rclcpp::Clock>())
  : DiagnosticTask(name), params_(params), clock_(clock) {clear();}
  explicit FrequencyStatus(
    const FrequencyStatusParam & params, const rclcpp::Clock::SharedPtr & clock = std::make_shared<rclcpp::Clock>())
  : FrequencyStatus(params, "Frequency Status", clock) {}

  /// Forget what was.
  void clear()
  {
    std::lock_guard<std::mutex> turn(lock_);
    count_ = 0;
    window_.assign(static_cast<size_t>(params_.window_size_), Report{clock_->now(), 0});
    oldest_ = 0;
  }
  void tick()
  {
    std::lock_guard<std::mutex> turn(lock_);
    ++count_;
  }
  void run(DiagnosticStatusWrapper & status) override
  {
    std::lock_guard<std::mutex> turn(lock_);
    Report now{clock_->now(), count_};
    int events = now.count - window_[oldest_].count;
    double seconds = (now.time - window_[oldest_].time).seconds();
    window_[oldest_] = now;
    oldest_ = (oldest_ + 1) % window_.size();
    judge(status, events, events / seconds);
    status.addf("Events in window", "%d", events);
    status.addf("Events since startup", "%d", count_);
    status.addf("Duration of window (s)", "%f", seconds);
    status.addf("Actual frequency (Hz)", "%f", events / seconds);
    tell_bounds(status);
  }

private:
  struct Report
  {
    rclcpp::Time time;
    int count;
  };
  void judge(DiagnosticStatusWrapper & status, int events, double frequency) const
  {
    if (events == 0) {
      status.summary(DiagnosticStatusWrapper::ERROR, "No events recorded.");
    } else if (frequency < params_.lowest()) {
      status.summary(DiagnosticStatusWrapper::WARN, "Frequency too low.");
    } else if (frequency > params_.highest()) {
      status.summary(DiagnosticStatusWrapper::WARN, "Frequency too high.");
    } else {
      status.summary(DiagnosticStatusWrapper::OK, "Desired frequency met");
    }
  }
  void tell_bounds(DiagnosticStatusWrapper & status) const
  {
    if (*params_.min_freq_ == *params_.max_freq_) {
      status.addf("Target frequency (Hz)", "%f", *params_.min_freq_);
    }
    if (*params_.min_freq_ > 0) {
      status.addf("Minimum acceptable frequency (Hz)", "%f", params_.lowest());
    }
    if (std::isfinite(*params_.max_freq_)) {
      status.addf("Maximum acceptable frequency (Hz)", "%f", params_.highest());
    }
  }

  const FrequencyStatusParam params_;
  const rclcpp::Clock::SharedPtr clock_;
  std::mutex lock_;
  std::vector<Report> window_;
  size_t oldest_ = 0;
  int count_ = 0;
};

/// Between which ages [s] a stamp is acceptable; a negative age is one of the future.
struct TimeStampStatusParam
{
  TimeStampStatusParam(const double min_acceptable = -1, const double max_acceptable = 5)  // NOLINT: as Humble's
  : max_acceptable_(max_acceptable), min_acceptable_(min_acceptable) {}
  double max_acceptable_;
  double min_acceptable_;
};
static TimeStampStatusParam DefaultTimeStampStatusParam = TimeStampStatusParam();

/// How old stamps are that `tick` is told, in seconds or as a time.
class TimeStampStatus : public DiagnosticTask
{
public:
  TimeStampStatus(
    const TimeStampStatusParam & params, std::string name,
    const rclcpp::Clock::SharedPtr & clock = std::make_shared<rclcpp::Clock>())
  : DiagnosticTask(name), params_(params), clock_(clock) {}
  explicit TimeStampStatus(
    const TimeStampStatusParam & params, const rclcpp::Clock::SharedPtr & clock = std::make_shared<rclcpp::Clock>())
  : TimeStampStatus(params, "Timestamp Status", clock) {}
  explicit TimeStampStatus(const rclcpp::Clock::SharedPtr & clock = std::make_shared<rclcpp::Clock>())
  : TimeStampStatus(TimeStampStatusParam(), clock) {}

  void tick(double stamp)
  {
    std::lock_guard<std::mutex> turn(lock_);
    if (stamp == 0) {
      zero_seen_ = true;
      return;
    }
    double age = clock_->now().seconds() - stamp;
    oldest_ = any_ ? std::max(oldest_, age) : age;
    youngest_ = any_ ? std::min(youngest_, age) : age;
    any_ = true;
  }
  void tick(const rclcpp::Time & stamp) {tick(stamp.seconds());}
  void run(DiagnosticStatusWrapper & status) override
  {
    std::lock_guard<std::mutex> turn(lock_);
    judge(status);
    status.addf("Earliest timestamp delay:", "%f", youngest_);
    status.addf("Latest timestamp delay:", "%f", oldest_);
    status.addf("Earliest acceptable timestamp delay:", "%f", params_.min_acceptable_);
    status.addf("Latest acceptable timestamp delay:", "%f", params_.max_acceptable_);
    status.add("Late diagnostic update count:", late_);
    status.add("Early diagnostic update count:", early_);
    status.add("Zero seen diagnostic update count:", zero_);
    any_ = zero_seen_ = false;
    youngest_ = oldest_ = 0;
  }

private:
  void judge(DiagnosticStatusWrapper & status)
  {
    status.summary(DiagnosticStatusWrapper::OK, "Timestamps are reasonable.");
    if (!any_) {
      status.summary(DiagnosticStatusWrapper::WARN, "No data since last update.");
      return;
    }
    if (youngest_ < params_.min_acceptable_) {
      status.summary(DiagnosticStatusWrapper::ERROR, "Timestamps too far in future seen.");
      ++early_;
    }
    if (oldest_ > params_.max_acceptable_) {
      status.summary(DiagnosticStatusWrapper::ERROR, "Timestamps too far in past seen.");
      ++late_;
    }
    if (zero_seen_) {
      status.summary(DiagnosticStatusWrapper::ERROR, "Zero timestamp seen.");
      ++zero_;
    }
  }

  TimeStampStatusParam params_;
  const rclcpp::Clock::SharedPtr clock_;
  std::mutex lock_;
  int early_ = 0, late_ = 0, zero_ = 0;
  bool any_ = false, zero_seen_ = false;
  double youngest_ = 0, oldest_ = 0;
};

/// Says that the node lives.
class Heartbeat : public DiagnosticTask
{
public:
  Heartbeat()
  : DiagnosticTask("Heartbeat") {}
  void run(DiagnosticStatusWrapper & status) override {status.summary(DiagnosticStatusWrapper::OK, "Alive");}
};
}  // namespace diagnostic_updater
