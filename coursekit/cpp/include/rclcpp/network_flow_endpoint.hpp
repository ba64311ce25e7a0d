// Where a publisher's or a subscription's packets flow. There is no network below coursekit, so nobody ever has one.
#pragma once
#include <cstdint>
#include <ostream>
#include <string>
#include <tuple>

namespace rclcpp
{
class NetworkFlowEndpoint
{
public:
  NetworkFlowEndpoint() = default;
  const std::string & transport_protocol() const {return transport_protocol_;}
  const std::string & internet_protocol() const {return internet_protocol_;}
  uint16_t transport_port() const {return transport_port_;}
  uint32_t flow_label() const {return flow_label_;}
  uint8_t dscp() const {return dscp_;}
  const std::string & internet_address() const {return internet_address_;}

private:
  std::string transport_protocol_, internet_protocol_, internet_address_;
  uint16_t transport_port_ = 0;
  uint32_t flow_label_ = 0;
  uint8_t dscp_ = 0;
};
inline bool operator==(const NetworkFlowEndpoint & a, const NetworkFlowEndpoint & b)
{
  return a.transport_protocol() == b.transport_protocol() && a.internet_protocol() == b.internet_protocol() &&
         a.transport_port() == b.transport_port() && a.flow_label() == b.flow_label() && a.dscp() == b.dscp() &&
         a.internet_address() == b.internet_address();
}
inline bool operator!=(const NetworkFlowEndpoint & a, const NetworkFlowEndpoint & b) {return !(a == b);}
inline std::ostream & operator<<(std::ostream & stream, const NetworkFlowEndpoint & one)
{
  return stream << "{\"transportProtocol\": \"" << one.transport_protocol() << "\", \"internetProtocol\": \"" <<
         one.internet_protocol() << "\", \"transportPort\": \"" << one.transport_port() << "\", \"flowLabel\": \"" <<
         one.flow_label() << "\", \"dscp\": \"" << static_cast<unsigned>(one.dscp()) << "\", \"internetAddress\": \"" <<
         one.internet_address() << "\"}";
}
}  // namespace rclcpp
