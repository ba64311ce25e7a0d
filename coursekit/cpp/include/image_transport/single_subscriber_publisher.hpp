// A publisher for one subscriber, which is told apart by its name.
#pragma once
#include <functional>
#include <string>

#include "sensor_msgs/msg/image.hpp"

namespace image_transport
{
class SingleSubscriberPublisher
{
public:
  using GetNumSubscribersFn = std::function<size_t()>;
  using PublishFn = std::function<void (const sensor_msgs::msg::Image &)>;
  SingleSubscriberPublisher(
    const std::string & caller_id, const std::string & topic, const GetNumSubscribersFn & num_subscribers_fn,
    const PublishFn & publish_fn)
  : caller_id_(caller_id), topic_(topic), num_subscribers_fn_(num_subscribers_fn), publish_fn_(publish_fn) {}
  SingleSubscriberPublisher(const SingleSubscriberPublisher &) = delete;
  SingleSubscriberPublisher & operator=(const SingleSubscriberPublisher &) = delete;
  std::string getSubscriberName() const {return caller_id_;}
  std::string getTopic() const {return topic_;}
  size_t getNumSubscribers() const {return num_subscribers_fn_();}
  void publish(const sensor_msgs::msg::Image & message) const {publish_fn_(message);}
  void publish(const sensor_msgs::msg::Image::ConstSharedPtr message) const {publish_fn_(*message);}

private:
  std::string caller_id_, topic_;
  GetNumSubscribersFn num_subscribers_fn_;
  PublishFn publish_fn_;
};
using SubscriberStatusCallback = std::function<void (const SingleSubscriberPublisher &)>;
}  // namespace image_transport
