// Callbacks that are called as long as who subscribed keeps what it got.
#pragma once
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace BT
{
template<class ... Args>
class Signal
{
public:
  using CallableFunction = std::function<void (Args ...)>;
  using Subscriber = std::shared_ptr<CallableFunction>;

  void notify(Args ... args)
  {
    for (size_t i = 0; i < subscribers_.size(); ) {
      if (Subscriber subscriber = subscribers_[i].lock()) {
        (*subscriber)(args ...);
        ++i;
      } else {
        subscribers_.erase(subscribers_.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
  }
  Subscriber subscribe(CallableFunction function)
  {
    auto subscriber = std::make_shared<CallableFunction>(std::move(function));
    subscribers_.push_back(subscriber);
    return subscriber;
  }

private:
  std::vector<std::weak_ptr<CallableFunction>> subscribers_;
};
}  // namespace BT
