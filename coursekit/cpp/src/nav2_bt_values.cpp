// Values of blackboards that cross: texts, numbers, and the messages that nav2's trees have.
#include "nav2_bt_values.hpp"

#include <vector>

#include "coursekit/frame.hpp"
#include "geometry_msgs/msg/pose_with_covariance_stamped.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "nav_msgs/msg/path.hpp"
#include "std_msgs/msg/string.hpp"

namespace BT
{
using coursekit::Packer;
using coursekit::Unpacker;

namespace
{
/// A type of values that cross, by its name.
struct CrossingType
{
  const std::type_info & type;
  std::string name;
  std::string (*packed)(const Any &);
  void (*put)(Blackboard &, const std::string & key, const std::string & bytes);
};
template<class M>
CrossingType message_type()
{
  return {
    typeid(M), rosidl_generator_traits::name<M>(), [](const Any & value) {return coursekit::to_cdr(value.cast<M>());},
    [](Blackboard & board, const std::string & key, const std::string & bytes) {
      M message;
      coursekit::from_cdr(bytes, message);
      board.set(key, message);
    }};
}
template<class M>
CrossingType messages_type()
{
  return {
    typeid(std::vector<M>), std::string(rosidl_generator_traits::name<M>()) + "[]", [](const Any & value) {
      Packer all;
      for (const M & message : value.cast<std::vector<M>>()) {
        all.m(message);
      }
      return all.bytes;
    },
    [](Blackboard & board, const std::string & key, const std::string & bytes) {
      std::vector<M> messages;
      for (Unpacker from{bytes}; from.at < bytes.size();) {
        messages.push_back(from.m<M>());
      }
      board.set(key, messages);
    }};
}
template<class... M>
std::vector<CrossingType> message_types() {return {message_type<M>()..., messages_type<M>()...};}

const std::vector<CrossingType> & crossing_types()
{
  using namespace geometry_msgs::msg;  // NOLINT
  static const auto known = message_types<
    Point, Pose, PoseStamped, PoseWithCovarianceStamped, Quaternion, Twist, TwistStamped, nav_msgs::msg::Path,
    std_msgs::msg::String>();
  return known;
}
/// A port of another type of numbers gets it as a text, which it reads itself.
template<class T>
void put_number(Blackboard & board, const std::string & key, T value, const std::string & text)
{
  const PortInfo * port = board.portInfo(key);
  if (port && port->type() && *port->type() != typeid(T)) {
    board.set(key, text);
  } else {
    board.set(key, value);
  }
}
}  // namespace

void put(Blackboard & board, const std::string & key, const std::string & type, const std::string & bytes)
{
  if (type == "str") {
    return board.set(key, bytes);
  }
  if (type == "bool") {
    return put_number(board, key, bytes == "True", bytes);
  }
  if (type == "int") {
    return put_number(board, key, std::stoi(bytes), bytes);
  }
  if (type == "float") {
    return put_number(board, key, std::stod(bytes), bytes);
  }
  for (const CrossingType & known : crossing_types()) {
    if (known.name == type) {
      return known.put(board, key, bytes);
    }
  }
}
std::pair<std::string, std::string> packed(const Any & value)
{
  if (value.isString()) {
    return {"str", value.cast<std::string>()};
  }
  if (value.type() == typeid(bool)) {
    return {"bool", value.cast<bool>() ? "True" : "False"};
  }
  if (value.isNumber()) {
    if (value.castedType() == typeid(double)) {
      return {"float", Packer{}.d(value.cast<double>()).bytes};
    }
    return {"int", value.cast<std::string>()};
  }
  for (const CrossingType & known : crossing_types()) {
    if (known.type == value.type()) {
      return {known.name, known.packed(value)};
    }
  }
  return {};
}
}  // namespace BT
