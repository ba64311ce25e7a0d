// Messages with values in them, for tests that send each kind of test_msgs.
#include "check.hpp"
#include "test_msgs/message_fixtures.hpp"

template<class Messages>
bool come_back(const Messages & messages)
{
  using Message = typename Messages::value_type::element_type;
  rclcpp::Serialization<Message> serialization;
  return !messages.empty() && std::all_of(
    messages.begin(), messages.end(), [&](const auto & one) {
      rclcpp::SerializedMessage bytes;
      Message again;
      serialization.serialize_message(one.get(), &bytes);
      serialization.deserialize_message(&bytes, &again);
      return again == *one;
    });
}

int main()
{
  check("numbers", come_back(get_messages_basic_types()) && get_messages_basic_types()[1]->bool_value);
  check("texts", come_back(get_messages_strings()) && get_messages_strings()[2]->string_value.size() > 1000);
  check("wide texts", come_back(get_messages_wstrings()));
  check("nothing", come_back(get_messages_empty()));
  check("constants and defaults", come_back(get_messages_constants()) && come_back(get_messages_defaults()));
  check("arrays", come_back(get_messages_arrays()) && get_messages_arrays()[0]->int8_values[2] == -128);
  check("lists", come_back(get_messages_unbounded_sequences()));
  check("bounded lists", come_back(get_messages_bounded_sequences()) && come_back(get_messages_bounded_plain_sequences()));
  check("messages in messages", come_back(get_messages_nested()) && come_back(get_messages_multi_nested()));
  check("times", come_back(get_messages_builtins()));
}
