// Publishes from a thread that must not wait: another one takes its message and sends it.
#pragma once
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include "rclcpp/publisher.hpp"

namespace realtime_tools
{
/// The one that publishes fills `msg_` between trylock() and unlockAndPublish().
template<class MessageT>
class RealtimePublisher
{
public:
  using PublisherSharedPtr = typename rclcpp::Publisher<MessageT>::SharedPtr;
  /// One that never publishes: a member until it is known what it publishes.
  RealtimePublisher() = default;
  explicit RealtimePublisher(PublisherSharedPtr publisher)
  : publisher_(std::move(publisher)), thread_([this] {send_all();}) {}
  ~RealtimePublisher()
  {
    stop();
    if (thread_.joinable()) {
      thread_.join();
    }
  }
  RealtimePublisher(const RealtimePublisher &) = delete;
  void stop()
  {
    std::lock_guard<std::mutex> hold(lock_);
    ends_ = true;
    wakes_.notify_one();
  }
  /// Whether the message may be written now: not while the last one is about to be sent.
  bool trylock()
  {
    if (!lock_.try_lock()) {
      return false;
    }
    if (full_) {
      lock_.unlock();
      return false;
    }
    return true;
  }
  bool tryPublish(const MessageT & message)
  {
    if (!trylock()) {
      return false;
    }
    msg_ = message;
    unlockAndPublish();
    return true;
  }
  void unlockAndPublish()
  {
    full_ = true;
    unlock();
  }
  void lock() {lock_.lock();}
  void unlock()
  {
    lock_.unlock();
    wakes_.notify_one();
  }
  std::thread & get_thread() {return thread_;}
  const std::thread & get_thread() const {return thread_;}

  MessageT msg_;

private:
  void send_all()
  {
    std::unique_lock<std::mutex> hold(lock_);
    for (;;) {
      wakes_.wait(hold, [this] {return full_ || ends_;});
      if (!full_) {
        return;
      }
      MessageT message = msg_;
      full_ = false;
      hold.unlock();
      publisher_->publish(message);
      hold.lock();
    }
  }
  PublisherSharedPtr publisher_;
  std::mutex lock_;
  std::condition_variable wakes_;
  bool full_ = false, ends_ = false;
  std::thread thread_;
};
template<class MessageT>
using RealtimePublisherSharedPtr = std::shared_ptr<RealtimePublisher<MessageT>>;
}  // namespace realtime_tools
