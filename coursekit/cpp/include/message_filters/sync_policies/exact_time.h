// Messages belong together whose stamps are equal.
#pragma once
#include <algorithm>
#include <map>
#include <mutex>

#include "message_filters/synchronizer.h"

namespace message_filters::sync_policies
{
template<class ... M>
class ExactTime : public PolicyOf<ExactTime<M...>, M...>
{
  using Base = PolicyOf<ExactTime, M...>;
  friend Base;

public:
  ExactTime(uint32_t queue_size)  // NOLINT: as Humble's, a number is a policy
  : queue_size_(queue_size) {}
  ExactTime(const ExactTime & other)
  : Base(other), queue_size_(other.queue_size_), sets_(other.sets_), drop_(other.drop_) {}
  /// Have a function called with each set that is given up; what of it has not come is null.
  template<class C>
  Connection registerDropCallback(const C & callback) {return drop_.addCallback(callback);}
  template<class C, class T>
  Connection registerDropCallback(const C & member, T * object) {return drop_.addCallback(member, object);}

protected:
  void take(size_t which, const Stamped & one)
  {
    std::vector<Stamped> whole;
    std::vector<std::vector<Stamped>> given_up;
    {
      std::lock_guard<std::mutex> hold(lock_);
      auto & set = sets_[one.time];
      set.resize(sizeof...(M));
      set[which] = one;
      bool complete = std::all_of(set.begin(), set.end(), [](auto & part) {return part.message != nullptr;});
      if (complete) {
        whole = set;
        sets_.erase(one.time);
        while (!sets_.empty() && sets_.begin()->first < one.time) {  // older ones will not be complete any more
          give_up_oldest(given_up);
        }
      }
      while (queue_size_ && sets_.size() > queue_size_) {
        give_up_oldest(given_up);
      }
    }
    if (!whole.empty()) {
      this->signal(whole);
    }
    for (auto & set : given_up) {
      std::apply([this](const auto & ... one) {drop_.call(one ...);}, Base::events(set, std::make_index_sequence<9>()));
    }
  }

private:
  void give_up_oldest(std::vector<std::vector<Stamped>> & given_up)
  {
    given_up.push_back(std::move(sets_.begin()->second));
    sets_.erase(sets_.begin());
  }
  uint32_t queue_size_;
  std::mutex lock_;
  std::map<int64_t, std::vector<Stamped>> sets_;
  typename Base::Signal drop_;
};
}  // namespace message_filters::sync_policies
