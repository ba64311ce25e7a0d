// Topics whose frequency and stamps are told, and publishers that do so by themselves.
#pragma once
#include <memory>
#include <string>
#include <utility>

#include "diagnostic_updater/update_functions.hpp"
#include "rclcpp/rclcpp.hpp"

namespace diagnostic_updater
{
/// How often a topic is published; `tick` is called each time.
class HeaderlessTopicDiagnostic : public CompositeDiagnosticTask
{
public:
  HeaderlessTopicDiagnostic(
    std::string name, Updater & updater, const FrequencyStatusParam & frequency,
    const rclcpp::Clock::SharedPtr & clock = std::make_shared<rclcpp::Clock>())
  : CompositeDiagnosticTask(name + " topic status"), frequency_(frequency, clock)
  {
    addTask(&frequency_);
    updater.add(*this);
  }
  virtual void tick() {frequency_.tick();}
  virtual void clear_window() {frequency_.clear();}

private:
  FrequencyStatus frequency_;
};

/// How often a topic is published, and how old its stamps are.
class TopicDiagnostic : public HeaderlessTopicDiagnostic
{
public:
  TopicDiagnostic(
    std::string name, Updater & updater, const FrequencyStatusParam & frequency, const TimeStampStatusParam & stamp,
    const rclcpp::Clock::SharedPtr & clock = std::make_shared<rclcpp::Clock>())
  : HeaderlessTopicDiagnostic(name, updater, frequency, clock), stamp_(stamp, clock)
  {
    addTask(&stamp_);
  }
  void tick() override
  {
    RCLCPP_FATAL(
      rclcpp::get_logger("TopicDiagnostic_error_logger"),
      "tick(void) has been called on a TopicDiagnostic. This is never correct. Use tick(rclcpp::Time &) instead.");
  }
  virtual void tick(const rclcpp::Time & stamp)
  {
    stamp_.tick(stamp);
    HeaderlessTopicDiagnostic::tick();
  }

private:
  TimeStampStatus stamp_;
};

/// A publisher of messages with headers that is watched.
template<class M, class A = std::allocator<void>>
class DiagnosedPublisher : public TopicDiagnostic
{
public:
  using PublisherT = rclcpp::Publisher<M, A>;
  DiagnosedPublisher(
    const std::shared_ptr<PublisherT> & publisher, Updater & updater, const FrequencyStatusParam & frequency,
    const TimeStampStatusParam & stamp)
  : TopicDiagnostic(publisher->get_topic_name(), updater, frequency, stamp), publisher_(publisher) {}
  virtual void publish(std::unique_ptr<M> message)
  {
    tick(message->header.stamp);
    publisher_->publish(std::move(message));
  }
  virtual void publish(const M & message)
  {
    tick(message.header.stamp);
    publisher_->publish(message);
  }
  std::shared_ptr<PublisherT> getPublisher() const {return publisher_;}
  void setPublisher(std::shared_ptr<PublisherT> publisher) {publisher_ = publisher;}

private:
  std::shared_ptr<PublisherT> publisher_;
};
}  // namespace diagnostic_updater
