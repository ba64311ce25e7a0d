// Every form in which a subscription's callback may take a message.
#include <functional>

#include "check.hpp"
#include "std_msgs/msg/int32.hpp"

using std_msgs::msg::Int32;
static int g_heard = 0;
static void plain_function(const Int32 & message) {g_heard = message.data;}
static void pointer_function(Int32::ConstSharedPtr message) {g_heard = message->data;}

struct Owner
{
  void by_reference(const Int32 & message) {heard = message.data;}
  void by_pointer(const Int32::SharedPtr message) const {heard = message->data;}
  void by_unique(Int32::UniquePtr message) {heard = message->data;}
  void with_more(const Int32 & message, int more) {heard = message.data + more;}
  mutable int heard = 0;
};
struct Functor
{
  void operator()(const Int32 & message) {*heard = message.data;}
  int * heard;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("callbacks");
  auto publisher = node->create_publisher<Int32>("number", 10);
  int number = 0;
  auto said = [&](const std::string & name, auto callback, int & heard) {
      auto subscription = node->create_subscription<Int32>("number", 10, callback);
      publisher->publish(Int32().set__data(++number));
      spin_until(node, [&] {return heard == number;});
      equal(name, heard, number);
    };
  int heard = 0;
  int64_t sent = 0;
  using Info = rclcpp::MessageInfo;
  said("const reference", [&](const Int32 & m) {heard = m.data;}, heard);
  said("shared pointer", [&](Int32::SharedPtr m) {heard = m->data;}, heard);
  said("const shared pointer", [&](const Int32::SharedPtr m) {heard = m->data;}, heard);
  said("pointer to const", [&](Int32::ConstSharedPtr m) {heard = m->data;}, heard);
  said("reference to pointer to const", [&](const Int32::ConstSharedPtr & m) {heard = m->data;}, heard);
  said("reference to shared pointer to const", [&](const std::shared_ptr<const Int32> & m) {heard = m->data;}, heard);
  said("unique pointer", [&](Int32::UniquePtr m) {heard = m->data;}, heard);
  said("std::unique_ptr", [&](std::unique_ptr<Int32> m) {heard = m->data;}, heard);
  said("const reference and info", [&](const Int32 & m, const Info & i) {
      heard = m.data;
      sent = i.get_rmw_message_info().source_timestamp;
    }, heard);
  check("info has the time of sending", sent > 0);
  said("shared pointer and info", [&](Int32::SharedPtr m, const Info &) {heard = m->data;}, heard);
  said("pointer to const and info", [&](Int32::ConstSharedPtr m, const Info &) {heard = m->data;}, heard);
  said("unique pointer and info", [&](Int32::UniquePtr m, const Info &) {heard = m->data;}, heard);
  said("serialized", [&](std::shared_ptr<rclcpp::SerializedMessage> m) {
      Int32 read;
      rclcpp::Serialization<Int32>().deserialize_message(m.get(), &read);
      heard = read.data;
    }, heard);
  said("serialized and info", [&](std::shared_ptr<const rclcpp::SerializedMessage> m, const Info &) {
      Int32 read;
      rclcpp::Serialization<Int32>().deserialize_message(m.get(), &read);
      heard = read.data;
    }, heard);
  Owner owner;
  using std::placeholders::_1;
  said("bound member with reference", std::bind(&Owner::by_reference, &owner, _1), owner.heard);
  said("bound const member with pointer", std::bind(&Owner::by_pointer, &owner, _1), owner.heard);
  said("bound member with unique pointer", std::bind(&Owner::by_unique, &owner, _1), owner.heard);
  owner.heard = 0;
  auto more = node->create_subscription<Int32>("number", 10, std::function<void (const Int32 &)>(
      std::bind(&Owner::with_more, &owner, _1, 100)));
  publisher->publish(Int32().set__data(++number));
  spin_until(node, [&] {return owner.heard == number + 100;});
  equal("bound member with more arguments", owner.heard, number + 100);
  more.reset();
  said("function", plain_function, g_heard);
  said("function with pointer", &pointer_function, g_heard);
  said("std::function", std::function<void (Int32::SharedPtr)>([&](Int32::SharedPtr m) {heard = m->data;}), heard);
  said("functor", Functor{&heard}, heard);
  said("mutable lambda", [&heard, count = 0](const Int32 & m) mutable {++count; heard = m.data;}, heard);
  rclcpp::shutdown();
}
