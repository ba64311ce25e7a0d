// A subscription as a filter.
#pragma once
#include "message_filters/simple_filter.h"

namespace message_filters
{
template<class N = rclcpp::Node>
class SubscriberBase
{
public:
  using NodePtr = std::shared_ptr<N>;
  virtual ~SubscriberBase() = default;
  virtual void subscribe() = 0;
  virtual void unsubscribe() = 0;
};

template<class M, class N = rclcpp::Node>
class Subscriber : public SubscriberBase<N>, public SimpleFilter<M>
{
public:
  using NodePtr = std::shared_ptr<N>;
  Subscriber() = default;
  Subscriber(NodePtr node, const std::string & topic, const rmw_qos_profile_t qos = rmw_qos_profile_default)
  {
    subscribe(node, topic, qos);
  }
  Subscriber(N * node, const std::string & topic, const rmw_qos_profile_t qos = rmw_qos_profile_default)
  {
    subscribe(node, topic, qos);
  }
  Subscriber(NodePtr node, const std::string & topic, const rmw_qos_profile_t qos, rclcpp::SubscriptionOptions options)
  {
    subscribe(node.get(), topic, qos, options);
  }
  Subscriber(N * node, const std::string & topic, const rmw_qos_profile_t qos, rclcpp::SubscriptionOptions options)
  {
    subscribe(node, topic, qos, options);
  }
  template<class P>
  Subscriber(P node, const std::string & topic, const rclcpp::QoS & qos, rclcpp::SubscriptionOptions options = {})
  : Subscriber(node, topic, qos.get_rmw_qos_profile(), options) {}
  template<class P>
  void subscribe(P node, const std::string & topic, const rclcpp::QoS & qos, rclcpp::SubscriptionOptions options = {})
  {
    subscribe(&rclcpp::node_of(node), topic, qos.get_rmw_qos_profile(), options);
  }
  void subscribe(NodePtr node, const std::string & topic, const rmw_qos_profile_t qos = rmw_qos_profile_default)
  {
    subscribe(node.get(), topic, qos, {});
  }
  void subscribe(NodePtr node, const std::string & topic, const rmw_qos_profile_t qos, rclcpp::SubscriptionOptions options)
  {
    subscribe(node.get(), topic, qos, options);
  }
  void subscribe(
    N * node, const std::string & topic, const rmw_qos_profile_t qos = rmw_qos_profile_default,
    rclcpp::SubscriptionOptions options = {})
  {
    unsubscribe();
    if (topic.empty()) {
      return;
    }
    node_ = node;
    topic_ = topic;
    qos_ = qos;
    options_ = options;
    subscribe();
  }
  void subscribe() override
  {
    if (!topic_.empty()) {
      subscription_ = node_->template create_subscription<M>(
        topic_, rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(qos_), qos_),
        [this](std::shared_ptr<const M> message) {this->signalMessage(message);}, options_);
    }
  }
  void unsubscribe() override {subscription_.reset();}
  std::string getTopic() const {return topic_;}
  const typename rclcpp::Subscription<M>::SharedPtr getSubscriber() const {return subscription_;}
  template<class F>
  void connectInput(F &) {}
  void add(const MessageEvent<M const> &) {}

private:
  N * node_ = nullptr;
  std::string topic_;
  rmw_qos_profile_t qos_ = rmw_qos_profile_default;
  rclcpp::SubscriptionOptions options_;
  typename rclcpp::Subscription<M>::SharedPtr subscription_;
};
}  // namespace message_filters
