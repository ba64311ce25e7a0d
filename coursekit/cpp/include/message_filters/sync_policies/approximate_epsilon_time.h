// Messages belong together whose stamps differ by no more than epsilon; the first such set is taken.
#pragma once
#include <algorithm>
#include <array>
#include <deque>
#include <mutex>

#include "message_filters/synchronizer.h"

namespace message_filters::sync_policies
{
template<class ... M>
class ApproximateEpsilonTime : public PolicyOf<ApproximateEpsilonTime<M...>, M...>
{
  using Base = PolicyOf<ApproximateEpsilonTime, M...>;
  friend Base;

public:
  ApproximateEpsilonTime(uint32_t queue_size, rclcpp::Duration epsilon)
  : queue_size_(queue_size), epsilon_(epsilon.nanoseconds()) {}
  ApproximateEpsilonTime(const ApproximateEpsilonTime & other)
  : Base(other), queue_size_(other.queue_size_), epsilon_(other.epsilon_), topics_(other.topics_) {}

protected:
  void take(size_t which, const Stamped & one)
  {
    std::vector<std::vector<Stamped>> sets;
    {
      std::lock_guard<std::mutex> hold(lock_);
      topics_[which].push_back(one);
      while (all_have_some()) {
        match(sets);
      }
      if (queue_size_ && topics_[which].size() > queue_size_) {
        topics_[which].pop_front();
      }
    }
    for (auto & set : sets) {
      this->signal(set);
    }
  }

private:
  bool all_have_some() const
  {
    return std::none_of(topics_.begin(), topics_.end(), [](auto & topic) {return topic.empty();});
  }
  /// Take the first messages of all where they are close, else give up the oldest.
  void match(std::vector<std::vector<Stamped>> & sets)
  {
    auto older = [](auto & a, auto & b) {return a.front().time < b.front().time;};
    auto [first, last] = std::minmax_element(topics_.begin(), topics_.end(), older);
    if (last->front().time - first->front().time > epsilon_) {
      first->pop_front();
      return;
    }
    sets.emplace_back();
    for (auto & topic : topics_) {
      sets.back().push_back(topic.front());
      topic.pop_front();
    }
  }

  uint32_t queue_size_;
  int64_t epsilon_;
  std::mutex lock_;
  std::array<std::deque<Stamped>, sizeof...(M)> topics_;
};
}  // namespace message_filters::sync_policies
