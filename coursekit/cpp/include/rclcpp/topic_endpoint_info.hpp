// What is known of a publisher or a subscription, wherever it is.
#pragma once
#include <algorithm>
#include <array>
#include <string>

#include "rclcpp/qos.hpp"

#define RMW_GID_STORAGE_SIZE 24u

namespace rclcpp
{
enum class EndpointType {Invalid = 0, Publisher = 1, Subscription = 2};

class TopicEndpointInfo
{
public:
  explicit TopicEndpointInfo(coursekit::Unpacker & from)
  : node_name_(from.s()), node_namespace_(from.s()), topic_type_(from.s()),
    endpoint_type_(static_cast<EndpointType>(from.i())), gid_(bytes(from.s())), qos_(QoS::unpack(from)) {}
  std::string & node_name() {return node_name_;}
  const std::string & node_name() const {return node_name_;}
  std::string & node_namespace() {return node_namespace_;}
  const std::string & node_namespace() const {return node_namespace_;}
  std::string & topic_type() {return topic_type_;}
  const std::string & topic_type() const {return topic_type_;}
  rclcpp::EndpointType & endpoint_type() {return endpoint_type_;}
  const rclcpp::EndpointType & endpoint_type() const {return endpoint_type_;}
  std::array<uint8_t, RMW_GID_STORAGE_SIZE> & endpoint_gid() {return gid_;}
  const std::array<uint8_t, RMW_GID_STORAGE_SIZE> & endpoint_gid() const {return gid_;}
  rclcpp::QoS & qos_profile() {return qos_;}
  const rclcpp::QoS & qos_profile() const {return qos_;}

private:
  static std::array<uint8_t, RMW_GID_STORAGE_SIZE> bytes(const std::string & text)
  {
    std::array<uint8_t, RMW_GID_STORAGE_SIZE> all{};
    std::copy_n(text.begin(), std::min<size_t>(text.size(), all.size()), all.begin());
    return all;
  }
  std::string node_name_, node_namespace_, topic_type_;
  rclcpp::EndpointType endpoint_type_;
  std::array<uint8_t, RMW_GID_STORAGE_SIZE> gid_;
  rclcpp::QoS qos_;
};
}  // namespace rclcpp
