#include "bag_qos.hpp"

#include <algorithm>
#include <sstream>

#include "rclcpp/rclcpp.hpp"

namespace rosbag2_transport
{
namespace
{
rclcpp::Logger logger() {return rclcpp::get_logger("rosbag2_transport");}
rclcpp::QoS profile(const rmw_qos_profile_t & policies)
{
  return rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(policies), policies);
}
std::string duration(const char * name, const rmw_time_t & time)
{
  return std::string("  ") + name + ":\n    sec: " + std::to_string(time.sec) + "\n    nsec: " + std::to_string(time.nsec) + "\n";
}
std::string number(const char * name, int value) {return std::string("  ") + name + ": " + std::to_string(value) + "\n";}
/// Set what a line of a profile says; a duration's two numbers have lines of their own.
void set(rmw_qos_profile_t & of, const std::string & group, const std::string & name, const std::string & value)
{
  const auto whole = static_cast<uint64_t>(std::strtoull(value.c_str(), nullptr, 10));
  if (name == "reliability") {
    of.reliability = static_cast<rmw_qos_reliability_policy_t>(whole);
  } else if (name == "durability") {
    of.durability = static_cast<rmw_qos_durability_policy_t>(whole);
  } else if (name == "liveliness") {
    of.liveliness = static_cast<rmw_qos_liveliness_policy_t>(whole);
  }
  for (auto [word, time] : {std::pair("deadline", &of.deadline), std::pair("lifespan", &of.lifespan),
      std::pair("liveliness_lease_duration", &of.liveliness_lease_duration)})
  {
    if (group == word && (name == "sec" || name == "nsec")) {
      (name == "sec" ? time->sec : time->nsec) = whole;
    }
  }
}
bool same(const rmw_time_t & a, const rmw_time_t & b) {return a.sec == b.sec && a.nsec == b.nsec;}
bool same_offer(const rclcpp::QoS & one, const rclcpp::QoS & other)
{
  const auto & a = one.get_rmw_qos_profile(), & b = other.get_rmw_qos_profile();
  return a.reliability == b.reliability && a.durability == b.durability && a.liveliness == b.liveliness &&
         same(a.deadline, b.deadline) && same(a.liveliness_lease_duration, b.liveliness_lease_duration);
}
}  // namespace

std::string offers_text(const std::vector<rclcpp::QoS> & offers)
{
  std::string text;
  for (const auto & offer : offers) {
    const auto & of = offer.get_rmw_qos_profile();
    text += "- history: 3\n  depth: 0\n" + number("reliability", of.reliability) + number("durability", of.durability) +
      duration("deadline", of.deadline) + duration("lifespan", of.lifespan) + number("liveliness", of.liveliness) +
      duration("liveliness_lease_duration", of.liveliness_lease_duration) + "  avoid_ros_namespace_conventions: false\n";
  }
  return text.substr(0, text.empty() ? 0 : text.size() - 1);
}
std::vector<rclcpp::QoS> parse_offers(const std::string & text)
{
  std::vector<rmw_qos_profile_t> found;
  std::istringstream lines(text);
  std::string group;
  for (std::string line; std::getline(lines, line); ) {
    const size_t colon = line.find(':'), begin = line.find_first_not_of(" -");
    if (colon == line.npos || begin == line.npos) {
      continue;
    }
    if (line.find_first_not_of(' ') != line.npos && line[line.find_first_not_of(' ')] == '-') {
      found.push_back(rmw_qos_profile_default);
    }
    const size_t value = line.find_first_not_of(' ', colon + 1);
    const std::string name = line.substr(begin, colon - begin);
    group = value == line.npos ? name : group;
    if (value != line.npos && !found.empty()) {
      set(found.back(), group, name, line.substr(value));
    }
  }
  std::vector<rclcpp::QoS> offers;
  std::transform(found.begin(), found.end(), std::back_inserter(offers), profile);
  return offers;
}
rclcpp::QoS request_for(const std::string & topic, const std::vector<rclcpp::QoS> & offers)
{
  const auto reliable = std::count_if(
    offers.begin(), offers.end(), [](auto & one) {return one.reliability() == rclcpp::ReliabilityPolicy::Reliable;});
  const auto latched = std::count_if(
    offers.begin(), offers.end(), [](auto & one) {return one.durability() == rclcpp::DurabilityPolicy::TransientLocal;});
  const auto all = static_cast<std::ptrdiff_t>(offers.size());
  if (reliable > 0 && reliable < all) {
    RCLCPP_WARN(
      logger(), "Some, but not all, publishers on topic \"%s\" are offering RMW_QOS_POLICY_RELIABILITY_RELIABLE. "
      "Falling back to RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT as it will connect to all publishers. "
      "Some messages from Reliable publishers could be dropped.", topic.c_str());
  }
  if (latched > 0 && latched < all) {
    RCLCPP_WARN(
      logger(), "Some, but not all, publishers on topic \"%s\" are offering RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL. "
      "Falling back to RMW_QOS_POLICY_DURABILITY_VOLATILE as it will connect to all publishers. "
      "Previously-published latched messages will not be retrieved.", topic.c_str());
  }
  rclcpp::QoS request((rclcpp::KeepAll()));  // no message may be lost while others are written
  request.reliability(reliable == all ? rclcpp::ReliabilityPolicy::Reliable : rclcpp::ReliabilityPolicy::BestEffort);
  request.durability(
    all > 0 && latched == all ? rclcpp::DurabilityPolicy::TransientLocal : rclcpp::DurabilityPolicy::Volatile);
  return request;
}
rclcpp::QoS offer_for(const std::string & topic, const std::vector<rclcpp::QoS> & recorded)
{
  if (recorded.empty()) {
    return rclcpp::QoS(10);
  }
  if (std::all_of(recorded.begin(), recorded.end(), [&](auto & one) {return same_offer(one, recorded[0]);})) {
    return recorded[0];
  }
  RCLCPP_WARN(
    logger(), "Not all original publishers on topic %s offered the same QoS profiles. Rosbag2 cannot yet choose an "
    "adapted profile to offer for this mixed case. Falling back to the rosbag2_transport default publisher offer.",
    topic.c_str());
  return rclcpp::QoS(10);
}
}  // namespace rosbag2_transport
