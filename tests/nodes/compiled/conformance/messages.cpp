// Messages: what their constructors give them, lists that are bounded, traits, bytes in YAML.
#include <iterator>

#include "check.hpp"
#include "diagnostic_msgs/msg/diagnostic_status.hpp"
#include "example_interfaces/action/fibonacci.hpp"
#include "example_interfaces/srv/add_two_ints.hpp"
#include "geometry_msgs/msg/point32.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/set_bool.hpp"
#include "test_msgs/msg/bounded_plain_sequences.hpp"
#include "test_msgs/msg/bounded_sequences.hpp"
#include "test_msgs/msg/defaults.hpp"
#include "test_msgs/msg/nested.hpp"

using rosidl_runtime_cpp::MessageInitialization;
using Three = rosidl_runtime_cpp::BoundedVector<int, 3>;
namespace traits = rosidl_generator_traits;

template<class T>
std::string shown(const T & values)
{
  std::string text;
  for (auto value : values) {
    text += std::to_string(value) + " ";
  }
  return text;
}
/// Whether a change that is too much is refused, and changes nothing.
template<class F>
void refuses(const std::string & name, Three values, F change)
{
  const Three before = values;
  std::string why = "threw nothing";
  try {
    change(values);
  } catch (const std::length_error & error) {
    why = error.what();
  }
  check(name, why == "Exceeded upper bound" && values == before, why);
}

void initialization()
{
  test_msgs::msg::Defaults all, zero(MessageInitialization::ZERO), defaults(MessageInitialization::DEFAULTS_ONLY);
  check("a message begins with its defaults", all.int8_value == -50 && all.bool_value && all.float64_value == 1.125);
  check("or with zeros", zero.int8_value == 0 && !zero.bool_value && zero.float64_value == 0);
  check("or with the defaults alone", defaults == all);
  test_msgs::msg::BoundedSequences skipped(MessageInitialization::SKIP), filled;
  check("or with nothing", skipped.int8_values_default.empty() && filled.int8_values_default.size() == 3);
  test_msgs::msg::Nested nested(MessageInitialization::ZERO);
  equal("and so do messages within it", nested.basic_types_value.int32_value, 0);
  static_assert(std::is_same_v<std_msgs::msg::String_<std::allocator<void>>, std_msgs::msg::String>);
}

void bounded()
{
  Three two{1, 2};
  refuses("more than it holds when made", {}, [](Three & v) {v = Three(4);});
  refuses("more by a list", {1}, [](Three & v) {v = {1, 2, 3, 4};});
  refuses("more by assign", {1}, [](Three & v) {v.assign(4, 7);});
  refuses("more by resize", {1}, [](Three & v) {v.resize(4);});
  refuses("more by reserve", {1}, [](Three & v) {v.reserve(4);});
  refuses("more by push_back", {1, 2, 3}, [](Three & v) {v.push_back(4);});
  refuses("more by emplace_back", {1, 2, 3}, [](Three & v) {v.emplace_back(4);});
  refuses("more by insert", {1, 2, 3}, [](Three & v) {v.insert(v.begin(), 4);});
  refuses("more by emplace", {1, 2, 3}, [](Three & v) {v.emplace(v.begin(), 4);});
  refuses("more copies", {1, 2}, [](Three & v) {v.insert(v.begin(), 2, 4);});
  refuses("more from elsewhere", {1, 2}, [&](Three & v) {v.insert(v.end(), two.begin(), two.end());});
  refuses("more from a stream", {1, 2}, [](Three & v) {
      std::istringstream text("3 4");
      v.insert(v.end(), std::istream_iterator<int>(text), std::istream_iterator<int>());
    });
  two.insert(two.begin() + 1, 9);
  equal("an item in the middle", shown(two), "1 9 2 ");
  two.erase(two.begin());
  two = {5, 6};
  equal("another list", shown(two), "5 6 ");
  equal("the most that it holds", two.max_size(), 3u);
  check("compared", Three{1, 2} < Three{1, 3} && Three{1} != two && two >= Three{5, 6});
  check("it is no vector", !std::is_convertible_v<Three, std::vector<int>>);
  rosidl_runtime_cpp::BoundedVector<bool, 2> flags{true, false};
  flags[1] = true;
  check("of booleans", flags == rosidl_runtime_cpp::BoundedVector<bool, 2>{true, true});
}

void known_types()
{
  using geometry_msgs::msg::Point32;
  using test_msgs::msg::BoundedPlainSequences;
  using test_msgs::msg::BoundedSequences;
  check("a fixed size", traits::has_fixed_size<Point32>::value && traits::has_fixed_size<test_msgs::msg::Nested>::value);
  check("no fixed size", !traits::has_fixed_size<std_msgs::msg::String>::value && !traits::has_fixed_size<int>::value);
  check("a bounded size", traits::has_bounded_size<Point32>::value && traits::has_bounded_size<BoundedPlainSequences>::value);
  check("no bounded size", !traits::has_bounded_size<BoundedSequences>::value);
  using Add = example_interfaces::srv::AddTwoInts;
  check("services' sizes", traits::has_fixed_size<Add>::value && !traits::has_fixed_size<std_srvs::srv::SetBool>::value);
  check("a service", traits::is_service<Add>::value && !traits::is_message<Add>::value && !traits::is_action<Add>::value);
  check("a request", traits::is_service_request<Add::Request>::value && traits::is_message<Add::Request>::value);
  check("a response", traits::is_service_response<Add::Response>::value && !traits::is_service_request<Add::Response>::value);
  using Fibonacci = example_interfaces::action::Fibonacci;
  check("an action", traits::is_action<Fibonacci>::value && traits::is_action_goal<Fibonacci::Goal>::value);
  check("its services", traits::is_service<Fibonacci::Impl::SendGoalService>::value);
  check("the service that cancels is that of all", std::is_same_v<Fibonacci::Impl::CancelGoalService, action_msgs::srv::CancelGoal>);
  using States = action_msgs::msg::GoalStatusArray;
  check("the states of goals, too", std::is_same_v<Fibonacci::Impl::GoalStatusMessage, States>);
}

int main()
{
  initialization();
  bounded();
  known_types();
  diagnostic_msgs::msg::DiagnosticStatus status;
  status.level = diagnostic_msgs::msg::DiagnosticStatus::STALE;
  equal("bytes in YAML", to_yaml(status, true).substr(0, 12), "{level: 0x03");
}
