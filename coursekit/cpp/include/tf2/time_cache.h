// Transforms of one frame over the last seconds, in a program's own memory. A buffer has its own, in the session.
#pragma once
#include <algorithm>
#include <list>
#include <memory>
#include <string>
#include <utility>

#include "tf2/exceptions.h"
#include "tf2/transform_storage.h"

namespace tf2
{
using P_TimeAndFrameID = std::pair<TimePoint, CompactFrameID>;
constexpr Duration TIMECACHE_DEFAULT_MAX_STORAGE_TIME = std::chrono::seconds(10);

class TimeCacheInterface
{
public:
  virtual ~TimeCacheInterface() = default;
  /// The transform at a time, or the newest at TimePointZero; false and the reason where there is none.
  virtual bool getData(TimePoint time, TransformStorage & out, std::string * why_not = nullptr) = 0;
  virtual bool insertData(const TransformStorage & new_data) = 0;
  virtual void clearList() = 0;
  /// The frame in which it is at a time; 0 where that is not known.
  virtual CompactFrameID getParent(TimePoint time, std::string * why_not) = 0;
  virtual P_TimeAndFrameID getLatestTimeAndParent() = 0;
  virtual unsigned int getListLength() = 0;
  virtual TimePoint getLatestTimestamp() = 0;
  virtual TimePoint getOldestTimestamp() = 0;
};
using TimeCacheInterfacePtr = std::shared_ptr<TimeCacheInterface>;

/// Keeps what came within a span of the newest, and interpolates between neighbours with one parent.
class TimeCache : public TimeCacheInterface
{
public:
  explicit TimeCache(Duration max_storage_time = TIMECACHE_DEFAULT_MAX_STORAGE_TIME)
  : span_(max_storage_time) {}
  bool getData(TimePoint time, TransformStorage & out, std::string * why_not = nullptr) override
  {
    const TransformStorage * later = nullptr, * earlier = nullptr;
    if (!find(time, later, earlier, why_not)) {
      return false;
    }
    if (!later || later->frame_id_ != earlier->frame_id_) {
      out = *earlier;
      return true;
    }
    double ratio = durationToSec(time - earlier->stamp_) / durationToSec(later->stamp_ - earlier->stamp_);
    out = *later;
    out.translation_.setInterpolate3(earlier->translation_, later->translation_, ratio);
    out.rotation_ = slerp(earlier->rotation_, later->rotation_, ratio);
    out.stamp_ = time;
    return true;
  }
  /// False for what is older than the span, and for what is there already.
  bool insertData(const TransformStorage & new_data) override
  {
    if (!kept_.empty() && kept_.front().stamp_ > new_data.stamp_ + span_) {
      return false;
    }
    auto at = std::find_if(kept_.begin(), kept_.end(), [&](auto & one) {return one.stamp_ <= new_data.stamp_;});
    auto same = std::find_if(at, kept_.end(), [&](auto & one) {return one.stamp_ < new_data.stamp_ || one == new_data;});
    if (same != kept_.end() && *same == new_data) {
      return false;
    }
    kept_.insert(at, new_data);
    while (kept_.back().stamp_ + span_ < kept_.front().stamp_) {
      kept_.pop_back();
    }
    return true;
  }
  void clearList() override {kept_.clear();}
  CompactFrameID getParent(TimePoint time, std::string * why_not) override
  {
    const TransformStorage * later = nullptr, * earlier = nullptr;
    return find(time, later, earlier, why_not) ? earlier->frame_id_ : 0;
  }
  P_TimeAndFrameID getLatestTimeAndParent() override
  {
    return kept_.empty() ? P_TimeAndFrameID() : P_TimeAndFrameID(kept_.front().stamp_, kept_.front().frame_id_);
  }
  unsigned int getListLength() override {return static_cast<unsigned>(kept_.size());}
  TimePoint getLatestTimestamp() override {return kept_.empty() ? TimePoint() : kept_.front().stamp_;}
  TimePoint getOldestTimestamp() override {return kept_.empty() ? TimePoint() : kept_.back().stamp_;}

protected:
  const std::list<TransformStorage> & getAllItems() const {return kept_;}

private:
  static bool no(std::string * why_not, const std::string & reason)
  {
    if (why_not) {
      *why_not = reason;
    }
    return false;
  }
  static std::string said(const TimePoint & time) {return displayTimePoint(time);}
  /// What stands at a time (as `earlier`), or around it.
  bool find(TimePoint time, const TransformStorage * & later, const TransformStorage * & earlier, std::string * why_not) const
  {
    if (kept_.empty()) {
      return no(why_not, "Lookup would require extrapolation at time " + said(time) + ", but no transforms are in the buffer");
    }
    const TimePoint newest = kept_.front().stamp_, oldest = kept_.back().stamp_;
    if (time == TimePointZero || time == newest) {
      earlier = &kept_.front();
      return true;
    }
    if (kept_.size() == 1) {
      return no(
        why_not, "Lookup would require extrapolation at time " + said(time) + ", but only time " + said(newest) +
        " is in the buffer");
    }
    if (time > newest) {
      return no(
        why_not, "Lookup would require extrapolation into the future.  Requested time " + said(time) +
        " but the latest data is at time " + said(newest));
    }
    if (time < oldest) {
      return no(
        why_not, "Lookup would require extrapolation into the past.  Requested time " + said(time) +
        " but the earliest data is at time " + said(oldest));
    }
    auto at = std::find_if(kept_.begin(), kept_.end(), [&](auto & one) {return one.stamp_ <= time;});
    earlier = &*at;
    later = at->stamp_ == time ? nullptr : &*std::prev(at);
    return true;
  }
  Duration span_;
  std::list<TransformStorage> kept_;  // the newest first
};

/// One transform for all times.
class StaticCache : public TimeCacheInterface
{
public:
  bool getData(TimePoint time, TransformStorage & out, std::string * = nullptr) override
  {
    out = kept_;
    out.stamp_ = time;
    return true;
  }
  bool insertData(const TransformStorage & new_data) override
  {
    kept_ = new_data;
    return true;
  }
  void clearList() override {}
  CompactFrameID getParent(TimePoint, std::string *) override {return kept_.frame_id_;}
  P_TimeAndFrameID getLatestTimeAndParent() override {return {TimePoint(), kept_.frame_id_};}
  unsigned int getListLength() override {return 1;}
  TimePoint getLatestTimestamp() override {return TimePoint();}
  TimePoint getOldestTimestamp() override {return TimePoint();}

private:
  TransformStorage kept_;
};
}  // namespace tf2
