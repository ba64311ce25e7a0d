// Messages belong together whose stamps are close: of all sets the one that spans the least time.
#pragma once
#include <algorithm>
#include <deque>
#include <limits>
#include <mutex>

#include "message_filters/synchronizer.h"

namespace message_filters::sync_policies
{
/// Finds the sets, whatever the messages are.
///
/// Each topic has a queue. The newest of their first messages is the pivot: a set must hold it, or a better one is found
/// while older first messages are passed over. A set is given as soon as nothing that may still come can be closer.
class ApproximateMatcher
{
public:
  using Emit = std::function<void (const std::vector<Stamped> &)>;
  ApproximateMatcher(size_t count, uint32_t queue_size)
  : queue_size_(queue_size), topics_(count)
  {
    if (!queue_size) {
      throw std::invalid_argument("the queue of an approximate policy holds at least one message");
    }
  }
  double age_penalty = 0.1;
  int64_t longest = std::numeric_limits<int64_t>::max();
  std::vector<int64_t> & lower_bounds()
  {
    bounds_.resize(topics_.size());
    return bounds_;
  }

  void take(size_t which, const Stamped & one, const Emit & emit)
  {
    Topic & topic = topics_[which];
    topic.waiting.push_back(one);
    if (topic.waiting.size() == 1 && all_have_some()) {
      process(emit);
    }
    if (topic.waiting.size() + topic.past.size() > queue_size_) {
      recover_all();
      topic.waiting.pop_front();
      topic.dropped = true;
      pivot_ = NONE;
      if (all_have_some()) {
        process(emit);
      }
    }
  }

private:
  static constexpr size_t NONE = std::numeric_limits<size_t>::max();
  struct Topic
  {
    std::deque<Stamped> waiting;
    std::vector<Stamped> past;
    bool dropped = false;
    void move_to_past()
    {
      past.push_back(waiting.front());
      waiting.pop_front();
    }
    void recover(size_t count)
    {
      for (; count > 0; --count) {
        waiting.push_front(past.back());
        past.pop_back();
      }
    }
  };
  struct Span {size_t first, last; int64_t start, end;};

  bool all_have_some() const
  {
    return std::all_of(topics_.begin(), topics_.end(), [](const Topic & topic) {return !topic.waiting.empty();});
  }
  void recover_all()
  {
    for (auto & topic : topics_) {
      topic.recover(topic.past.size());
    }
  }
  /// The oldest and the newest of the times that topics stand at.
  template<class F>
  Span span(F time_of) const
  {
    Span found{0, 0, time_of(0), time_of(0)};
    for (size_t i = 1; i < topics_.size(); ++i) {
      int64_t time = time_of(i);
      if (time < found.start) {
        found.first = i;
        found.start = time;
      }
      if (time > found.end) {
        found.last = i;
        found.end = time;
      }
    }
    return found;
  }
  int64_t front_time(size_t i) const {return topics_[i].waiting.front().time;}
  /// When the next message of a topic may come at the earliest, where there is none yet.
  int64_t virtual_time(size_t i) const
  {
    auto & topic = topics_[i];
    if (!topic.waiting.empty()) {
      return topic.waiting.front().time;
    }
    int64_t gap = i < bounds_.size() ? bounds_[i] : 0;
    return std::max(topic.past.back().time + gap, pivot_time_);
  }
  void make_candidate(const Span & s)
  {
    candidate_.clear();
    for (auto & topic : topics_) {
      candidate_.push_back(topic.waiting.front());
      topic.past.clear();
    }
    candidate_start_ = s.start;
    candidate_end_ = s.end;
  }
  /// Whether what begins at `start` and ends at `end` cannot be better than the candidate.
  bool no_better(int64_t end, int64_t start) const
  {
    return static_cast<double>(end - candidate_end_) * (1 + age_penalty) >= static_cast<double>(start - candidate_start_);
  }
  void publish(const Emit & emit)
  {
    std::vector<Stamped> set = std::move(candidate_);
    candidate_.clear();
    pivot_ = NONE;
    for (auto & topic : topics_) {
      topic.recover(topic.past.size());
      topic.waiting.pop_front();
    }
    emit(set);
  }
  /// Begin with a first candidate; false where the oldest message was given up instead.
  bool begin(const Span & s)
  {
    if (s.end - s.start > longest || topics_[s.last].dropped) {
      topics_[s.first].waiting.pop_front();
      return false;
    }
    make_candidate(s);
    pivot_ = s.last;
    pivot_time_ = s.end;
    return true;
  }
  void process(const Emit & emit)
  {
    while (all_have_some()) {
      Span s = span([this](size_t i) {return front_time(i);});
      for (size_t i = 0; i < topics_.size(); ++i) {
        topics_[i].dropped = topics_[i].dropped && i == s.last;
      }
      if (pivot_ == NONE) {
        if (!begin(s)) {
          continue;
        }
      } else if (!no_better(s.end, s.start)) {
        make_candidate(s);
      }
      topics_[s.first].move_to_past();
      if (s.first == pivot_ || no_better(s.end, pivot_time_)) {
        publish(emit);
      } else if (!all_have_some()) {
        prove(emit);
      }
    }
  }
  /// Some topic has no more messages: is the candidate the best, whatever comes?
  void prove(const Emit & emit)
  {
    std::vector<size_t> moved(topics_.size());
    for (;;) {
      Span s = span([this](size_t i) {return virtual_time(i);});
      if (no_better(s.end, pivot_time_)) {
        publish(emit);
        return;
      }
      if (!no_better(s.end, s.start)) {  // it cannot be told before more has come
        for (size_t i = 0; i < topics_.size(); ++i) {
          topics_[i].recover(moved[i]);
        }
        return;
      }
      topics_[s.first].move_to_past();
      ++moved[s.first];
    }
  }

  uint32_t queue_size_;
  std::vector<Topic> topics_;
  std::vector<int64_t> bounds_;
  std::vector<Stamped> candidate_;
  int64_t candidate_start_ = 0, candidate_end_ = 0, pivot_time_ = 0;
  size_t pivot_ = NONE;
};

template<class ... M>
class ApproximateTime : public PolicyOf<ApproximateTime<M...>, M...>
{
  using Base = PolicyOf<ApproximateTime, M...>;
  friend Base;

public:
  ApproximateTime(uint32_t queue_size)  // NOLINT: as Humble's, a number is a policy
  : matcher_(sizeof...(M), queue_size) {}
  ApproximateTime(const ApproximateTime & other)
  : Base(other), matcher_(other.matcher_) {}
  /// How much an older set is preferred to a closer one that comes later.
  void setAgePenalty(double penalty) {matcher_.age_penalty = penalty;}
  /// Messages of that topic are at least so far apart.
  void setInterMessageLowerBound(int which, rclcpp::Duration gap)
  {
    matcher_.lower_bounds().at(static_cast<size_t>(which)) = gap.nanoseconds();
  }
  /// A set spans at most so much time.
  void setMaxIntervalDuration(rclcpp::Duration longest) {matcher_.longest = longest.nanoseconds();}

protected:
  void take(size_t which, const Stamped & one)
  {
    std::lock_guard<std::recursive_mutex> hold(lock_);
    matcher_.take(which, one, [this](const std::vector<Stamped> & set) {this->signal(set);});
  }

private:
  std::recursive_mutex lock_;
  ApproximateMatcher matcher_;
};
}  // namespace message_filters::sync_policies
