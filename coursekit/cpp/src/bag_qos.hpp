// QoS in bags: as text in the metadata, as a recorder's request and as a player's offer.
#pragma once
#include <string>
#include <vector>

#include "rclcpp/qos.hpp"

namespace rosbag2_transport
{
/// The profiles of publishers as rosbag2 writes them. DDS does not tell history and depth: 3 (unknown) and 0.
std::string offers_text(const std::vector<rclcpp::QoS> & offers);
/// The profiles in the metadata of a bag.
std::vector<rclcpp::QoS> parse_offers(const std::string & text);
/// A request that fits all publishers of a topic.
rclcpp::QoS request_for(const std::string & topic, const std::vector<rclcpp::QoS> & offers);
/// The offer of the recorded publishers if they agree, else the default.
rclcpp::QoS offer_for(const std::string & topic, const std::vector<rclcpp::QoS> & recorded);
}  // namespace rosbag2_transport
