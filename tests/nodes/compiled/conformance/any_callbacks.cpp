// The holders of a subscription's and a service's callback, and entities that a program constructs itself.
#include "check.hpp"
#include "rclcpp/any_service_callback.hpp"
#include "rclcpp/any_subscription_callback.hpp"
#include "rclcpp/subscription_factory.hpp"
#include "rclcpp/publisher_factory.hpp"
#include "std_msgs/msg/int32.hpp"
#include "std_srvs/srv/set_bool.hpp"

using std_msgs::msg::Int32;
using std_srvs::srv::SetBool;

static std::string text_of(const std::function<void ()> & what)
{
  try {
    what();
  } catch (const std::runtime_error & error) {
    return error.what();
  }
  return "";
}
static std::shared_ptr<Int32> number(int data) {return std::make_shared<Int32>(Int32().set__data(data));}

static void of_subscriptions()
{
  const rclcpp::MessageInfo info;
  rclcpp::AnySubscriptionCallback<Int32> any;
  const std::string unset = " called on an unset AnySubscriptionCallback";
  equal("unset", text_of([&] {any.dispatch(number(1), info);}), "dispatch" + unset);
  auto by_shared = [&] {any.dispatch_intra_process(std::shared_ptr<const Int32>(number(1)), info);};
  equal("unset within the process", text_of(by_shared), "dispatch_intra_process" + unset);
  int heard = 0;
  any.set([&](const Int32 & message) {heard = message.data;});
  any.dispatch(number(2), info);
  equal("set", heard, 2);
  by_shared();
  equal("within the process", heard, 1);
  any.dispatch(std::make_shared<rclcpp::SerializedMessage>(coursekit::to_cdr(*number(3))), info);
  equal("bytes become a message", heard, 3);
  check("one that looks shares", any.use_take_shared_method() && !any.is_serialized_message_callback());

  const Int32 * kept = nullptr;
  any.set([&](Int32::UniquePtr message) {kept = message.release();});
  check("one that owns does not", !any.use_take_shared_method());
  auto whole = std::make_unique<Int32>();
  const Int32 * given = whole.get();
  any.dispatch_intra_process(std::move(whole), info);
  check("it gets the very object", kept == given);
  delete kept;
  auto shared = number(4);
  any.dispatch(shared, info);
  check("or a copy of one that others have", kept != shared.get() && kept->data == 4);
  delete kept;

  size_t bytes = 0;
  rclcpp::AnySubscriptionCallback<Int32> raw;
  raw.set([&](std::shared_ptr<rclcpp::SerializedMessage> message) {bytes = message->size();});
  raw.dispatch(std::make_shared<rclcpp::SerializedMessage>(coursekit::to_cdr(*number(5))), info);
  check("bytes", raw.is_serialized_message_callback() && bytes == 8);
  equal(
    "no message to bytes", text_of([&] {raw.dispatch(number(6), info);}),
    std::string("Cannot dispatch std::shared_ptr<ROSMessageType> message to rclcpp::SerializedMessage"));
}

static void of_services()
{
  using Any = rclcpp::AnyServiceCallback<SetBool>;
  auto header = std::make_shared<rmw_request_id_t>();
  auto request = std::make_shared<SetBool::Request>();
  request->data = true;
  Any any;
  auto ask = [&] {return any.dispatch(nullptr, header, request);};
  equal("no service without callback", text_of([&] {ask();}), std::string("unexpected request without any callback set"));
  any.set([](SetBool::Request::SharedPtr asked, SetBool::Response::SharedPtr said) {said->success = asked->data;});
  check("it answers", ask()->success);
  any.set(
    [&](Any::Header given, SetBool::Request::SharedPtr, SetBool::Response::SharedPtr said) {said->success = given == header;});
  check("with the header", ask()->success);
  bool later = false;
  any.set([&](Any::Header, SetBool::Request::SharedPtr) {later = true;});
  check("what is put off has no answer", !ask() && later);
  std::function<void (SetBool::Request::SharedPtr, SetBool::Response::SharedPtr)> none;
  throws<std::invalid_argument>("no callback", [&] {any.set(none);});
}

static void made_by_hand(const rclcpp::Node::SharedPtr & node)
{
  int heard = 0;
  rclcpp::AnySubscriptionCallback<Int32> any;
  any.set([&](const Int32 & message) {heard = message.data;});
  auto topics = node->get_node_topics_interface();
  auto subscription = std::make_shared<rclcpp::Subscription<Int32>>(
    node->get_node_base_interface().get(), rclcpp::get_message_type_support_handle<Int32>(), "number", 10, any,
    rclcpp::SubscriptionOptions(), nullptr);
  equal("its topic", std::string(subscription->get_topic_name()), std::string("/number"));
  topics->add_subscription(subscription, nullptr);
  auto publisher = node->create_publisher<Int32>("number", 10);
  publisher->publish(*number(7));
  check("a subscription made by hand hears", spin_until(node, [&] {return heard == 7;}));

  auto factory = rclcpp::create_subscription_factory<Int32>(
    [&](Int32::ConstSharedPtr message) {heard = -message->data;}, rclcpp::SubscriptionOptions(),
    rclcpp::message_memory_strategy::MessageMemoryStrategy<Int32>::create_default());
  auto made = topics->create_subscription("other", factory, rclcpp::QoS(5));
  auto group = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
  topics->add_subscription(made, group);
  check("in the group that it is given", group->find_subscription_ptrs_if([&](auto one) {return one == made;}) != nullptr);
  auto publishers = rclcpp::create_publisher_factory<Int32>(rclcpp::PublisherOptions());
  auto other = std::dynamic_pointer_cast<rclcpp::Publisher<Int32>>(topics->create_publisher("other", publishers, rclcpp::QoS(5)));
  topics->add_publisher(other, nullptr);
  other->publish(*number(8));
  check("so does one of a factory", spin_until(node, [&] {return heard == -8;}));
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  of_subscriptions();
  of_services();
  made_by_hand(rclcpp::Node::make_shared("by_hand"));
  rclcpp::shutdown();
}
