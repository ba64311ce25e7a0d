// Messages belong together whose stamps are equal.
#pragma once
#include "message_filters/synchronizer.h"

namespace message_filters::sync_policies
{
template<class ... M>
class ExactTime : public PolicyBase<M...>
{
public:
  ExactTime(uint32_t queue_size)  // NOLINT: as Humble's, a number is a policy
  : queue_size_(queue_size) {}
  ExactTime(const ExactTime & other)
  : PolicyBase<M...>(other), queue_size_(other.queue_size_), sets_(other.sets_) {}

protected:
  void take(size_t which, const Stamped & one)
  {
    std::vector<Stamped> whole;
    {
      std::lock_guard<std::mutex> hold(lock_);
      auto & set = sets_[one.time];
      set.resize(sizeof...(M));
      set[which] = one;
      bool complete = std::all_of(set.begin(), set.end(), [](auto & part) {return part.message != nullptr;});
      if (complete) {
        whole = set;
        sets_.erase(sets_.begin(), sets_.upper_bound(one.time));  // older ones will not be complete any more
      }
      while (queue_size_ && sets_.size() > queue_size_) {
        sets_.erase(sets_.begin());
      }
    }
    if (!whole.empty()) {
      this->signal(whole);
    }
  }

private:
  uint32_t queue_size_;
  std::mutex lock_;
  std::map<int64_t, std::vector<Stamped>> sets_;
};
}  // namespace message_filters::sync_policies
