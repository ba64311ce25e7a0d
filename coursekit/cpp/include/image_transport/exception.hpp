// What goes wrong with images, and which form of them a subscriber wants.
#pragma once
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/image.hpp"

namespace image_transport
{
class Exception : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
class TransportLoadException : public Exception
{
public:
  TransportLoadException(const std::string & transport, const std::string & text)
  : Exception("Unable to load plugin for transport '" + transport + "', error string:\n" + text), transport_(transport) {}
  std::string getTransport() const {return transport_;}

private:
  std::string transport_;
};

/// The transport that a subscriber wants: its node's parameter, "raw" without it.
class TransportHints
{
public:
  explicit TransportHints(
    const rclcpp::Node * node, const std::string & default_transport = "raw",
    const std::string & parameter_name = "image_transport")
  : transport_(node->get_parameter_or<std::string>(parameter_name, default_transport)) {}
  const std::string & getTransport() const {return transport_;}

private:
  std::string transport_;
};

namespace detail
{
inline rclcpp::QoS qos_of(const rmw_qos_profile_t & profile)
{
  return rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(profile), profile);
}
}  // namespace detail
}  // namespace image_transport
