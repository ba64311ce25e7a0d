// The synchronizer of equal stamps.
#pragma once
#include "message_filters/sync_policies/exact_time.h"

namespace message_filters
{
template<class ... M>
class TimeSynchronizer : public Synchronizer<sync_policies::ExactTime<M...>>
{
  using Policy = sync_policies::ExactTime<M...>;
  using Base = Synchronizer<Policy>;

public:
  explicit TimeSynchronizer(uint32_t queue_size)
  : Base(Policy(queue_size)) {}
  /// Of so many filters, and last the size of the queue.
  template<class F0, class ... A, class = std::enable_if_t<sizeof...(A) == sizeof...(M)>>
  TimeSynchronizer(F0 & f0, A && ... rest)
  : Base(Policy(static_cast<uint32_t>(std::get<sizeof...(A) - 1>(std::forward_as_tuple(rest ...)))))
  {
    connect_all(std::forward_as_tuple(f0, rest ...), std::make_index_sequence<sizeof...(M)>());
  }

#define COURSEKIT_ADD(i) \
  template<class P> \
  void add ## i(const P & message) {this->template add<i>(message);}
  COURSEKIT_ADD(0)
  COURSEKIT_ADD(1)
  COURSEKIT_ADD(2)
  COURSEKIT_ADD(3)
  COURSEKIT_ADD(4)
  COURSEKIT_ADD(5)
  COURSEKIT_ADD(6)
  COURSEKIT_ADD(7)
  COURSEKIT_ADD(8)
#undef COURSEKIT_ADD

private:
  template<class T, size_t ... i>
  void connect_all(const T & filters, std::index_sequence<i...>) {this->connectInput(std::get<i>(filters)...);}
};
}  // namespace message_filters
