// Messages of test_msgs with values in them, for tests that send each kind.
#pragma once
#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <memory>
#include <vector>

#include "test_msgs/msg/arrays.hpp"
#include "test_msgs/msg/basic_types.hpp"
#include "test_msgs/msg/bounded_plain_sequences.hpp"
#include "test_msgs/msg/bounded_sequences.hpp"
#include "test_msgs/msg/builtins.hpp"
#include "test_msgs/msg/constants.hpp"
#include "test_msgs/msg/defaults.hpp"
#include "test_msgs/msg/empty.hpp"
#include "test_msgs/msg/multi_nested.hpp"
#include "test_msgs/msg/nested.hpp"
#include "test_msgs/msg/strings.hpp"
#include "test_msgs/msg/unbounded_sequences.hpp"
#include "test_msgs/msg/w_strings.hpp"

namespace coursekit::fixtures
{
template<class T>
using Messages = std::vector<typename T::SharedPtr>;
template<class T>
Messages<T> all_of(std::initializer_list<T> messages)
{
  Messages<T> all;
  for (auto & message : messages) {
    all.push_back(std::make_shared<T>(message));
  }
  return all;
}
template<class F>
void put(F & sequence, std::initializer_list<typename F::value_type> values) {sequence.assign(values.begin(), values.end());}
template<class T, size_t N>
void put(std::array<T, N> & array, std::initializer_list<typename std::array<T, N>::value_type> values)
{
  std::copy(values.begin(), values.end(), array.begin());
}
/// The same number in every field.
inline test_msgs::msg::BasicTypes basic(int8_t value)
{
  test_msgs::msg::BasicTypes message;
  message.bool_value = value != 0;
  message.byte_value = message.char_value = message.uint8_value = static_cast<uint8_t>(value);
  message.float32_value = value * 1.125f;
  message.float64_value = value * 1.125;
  message.int8_value = value;
  message.int16_value = message.int32_value = value;
  message.int64_value = value;
  message.uint16_value = static_cast<uint16_t>(value);
  message.uint32_value = static_cast<uint32_t>(value);
  message.uint64_value = static_cast<uint64_t>(value);
  return message;
}
template<class F>
void put_limits(F & field)
{
  using Limits = std::numeric_limits<typename F::value_type>;
  put(field, {0, Limits::max(), Limits::min()});
}
/// Fill what arrays and plain sequences have in common.
template<class M>
M plain()
{
  M message;
  put(message.bool_values, {false, true, false});
  put(message.byte_values, {0, 1, 0xff});
  put(message.char_values, {0, 1, 127});
  put(message.float32_values, {1.125f, 0.0f, -1.125f});
  put(message.float64_values, {3.1415, 0.0, -3.1415});
  put_limits(message.int8_values);
  put_limits(message.uint8_values);
  put_limits(message.int16_values);
  put_limits(message.uint16_values);
  put_limits(message.int32_values);
  put_limits(message.uint32_values);
  put_limits(message.int64_values);
  put_limits(message.uint64_values);
  put(message.basic_types_values, {basic(0), basic(1), basic(-1)});
  message.alignment_check = 4;
  return message;
}
/// The same with strings.
template<class M>
M worded()
{
  M message = plain<M>();
  put(message.string_values, {"", "max value", "optional min value"});
  return message;
}
}  // namespace coursekit::fixtures

inline auto get_messages_empty() {return coursekit::fixtures::all_of({test_msgs::msg::Empty()});}
inline auto get_messages_basic_types()
{
  using coursekit::fixtures::basic;
  return coursekit::fixtures::all_of({basic(0), basic(1), basic(127), basic(-128)});
}
inline auto get_messages_constants() {return coursekit::fixtures::all_of({test_msgs::msg::Constants()});}
inline auto get_messages_defaults() {return coursekit::fixtures::all_of({test_msgs::msg::Defaults()});}
inline auto get_messages_strings()
{
  test_msgs::msg::Strings worded, longest;
  worded.string_value = worded.bounded_string_value = "Hello world!";
  longest.string_value.assign(20000, 'a');
  longest.bounded_string_value.assign(22, 'z');
  return coursekit::fixtures::all_of({test_msgs::msg::Strings(), worded, longest});
}
inline auto get_messages_arrays() {return coursekit::fixtures::all_of({coursekit::fixtures::worded<test_msgs::msg::Arrays>()});}
inline auto get_messages_unbounded_sequences()
{
  using test_msgs::msg::UnboundedSequences;
  return coursekit::fixtures::all_of({coursekit::fixtures::worded<UnboundedSequences>(), UnboundedSequences()});
}
inline auto get_messages_bounded_plain_sequences()
{
  using test_msgs::msg::BoundedPlainSequences;
  return coursekit::fixtures::all_of({coursekit::fixtures::plain<BoundedPlainSequences>(), BoundedPlainSequences()});
}
inline auto get_messages_bounded_sequences()
{
  using test_msgs::msg::BoundedSequences;
  return coursekit::fixtures::all_of({coursekit::fixtures::worded<BoundedSequences>(), BoundedSequences()});
}
inline auto get_messages_multi_nested()
{
  test_msgs::msg::MultiNested message;
  message.array_of_arrays.fill(*get_messages_arrays()[0]);
  message.array_of_bounded_sequences.fill(*get_messages_bounded_sequences()[0]);
  message.bounded_sequence_of_arrays.push_back(*get_messages_arrays()[0]);
  message.unbounded_sequence_of_unbounded_sequences.push_back(*get_messages_unbounded_sequences()[0]);
  return coursekit::fixtures::all_of({message});
}
inline auto get_messages_nested()
{
  test_msgs::msg::Nested message;
  message.basic_types_value = coursekit::fixtures::basic(1);
  return coursekit::fixtures::all_of({message, test_msgs::msg::Nested()});
}
inline auto get_messages_builtins()
{
  test_msgs::msg::Builtins message;
  message.duration_value.sec = -1234567890;
  message.duration_value.nanosec = 123456789;
  message.time_value.sec = -1234567890;
  message.time_value.nanosec = 987654321;
  return coursekit::fixtures::all_of({message});
}
inline auto get_messages_wstrings()
{
  test_msgs::msg::WStrings plain, umlauts, japanese;
  plain.wstring_value = u"ascii";
  umlauts.wstring_value = u"H\u00ebll\u00f6 W\u00f6rld";
  japanese.wstring_value = u"\u30cf\u30ed\u30fc\u30ef\u30fc\u30eb\u30c9";
  return coursekit::fixtures::all_of({plain, umlauts, japanese});
}
