// Callbacks that are called as soon as something new has come, before an executor has taken it.
#include "check.hpp"
#include "example_interfaces/action/fibonacci.hpp"
#include "example_interfaces/srv/add_two_ints.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "std_msgs/msg/int32.hpp"

using example_interfaces::action::Fibonacci;
using example_interfaces::srv::AddTwoInts;
using std_msgs::msg::Int32;

/// Wait until something holds while no executor runs, at most so long.
template<class F>
bool comes(F holds, std::chrono::nanoseconds limit = 5s)
{
  rclcpp::Clock clock(RCL_STEADY_TIME);
  for (auto end = clock.now() + rclcpp::Duration(limit); !holds() && clock.now() < end; ) {
    rclcpp::sleep_for(5ms);
  }
  return holds();
}
/// The text of what is thrown.
template<class F>
std::string text_of(F what)
{
  try {
    what();
  } catch (const std::invalid_argument & error) {
    return error.what();
  }
  return "threw nothing";
}

void topics(rclcpp::Node::SharedPtr node)
{
  auto publisher = node->create_publisher<Int32>("number", 10);
  int heard = 0;
  auto subscription = node->create_subscription<Int32>("number", 10, [&](const Int32 &) {++heard;});
  std::atomic<size_t> first{0}, second{0};
  auto set = [&](std::function<void (size_t)> callback) {subscription->set_on_new_message_callback(callback);};
  set([&](size_t count) {first += count;});
  publisher->publish(Int32());
  check("a message is told", comes([&] {return first == 1;}));
  equal("before it is heard", heard, 0);
  publisher->publish(Int32());
  publisher->publish(Int32());
  check("each of them", comes([&] {return first == 3;}));
  subscription->clear_on_new_message_callback();
  publisher->publish(Int32());
  rclcpp::sleep_for(30ms);
  equal("no more after it is cleared", first.load(), 3u);
  set([&](size_t count) {second += count;});
  check("what came meanwhile is told at once", comes([&] {return second == 1;}));
  set([&](size_t count) {first += count;});
  publisher->publish(Int32());
  check("another callback takes its place", comes([&] {return first == 4;}));
  rclcpp::sleep_for(30ms);
  check("nothing is told twice", first == 4 && second == 1);
  check("they are heard all the same", spin_until(node, [&] {return heard == 5;}));
  equal("an empty one is refused", text_of([&] {set(nullptr);}),
    "The callback passed to set_on_new_message_callback is not callable.");
  std::atomic<bool> threw{false};
  set([&](size_t) {
      threw = true;
      throw std::runtime_error("of mine");
    });
  publisher->publish(Int32());
  check("one that throws does no harm", comes([&] {return threw.load();}) && spin_until(node, [&] {return heard == 6;}));
}

void services(rclcpp::Node::SharedPtr node)
{
  auto service = node->create_service<AddTwoInts>(
    "sum", [](AddTwoInts::Request::SharedPtr request, AddTwoInts::Response::SharedPtr response) {
      response->sum = request->a + request->b;
    });
  auto client = node->create_client<AddTwoInts>("sum");
  std::atomic<size_t> requests{0}, responses{0};
  service->set_on_new_request_callback([&](size_t count) {requests += count;});
  client->set_on_new_response_callback([&](size_t count) {responses += count;});
  auto future = client->async_send_request(std::make_shared<AddTwoInts::Request>());
  check("a request is told", comes([&] {return requests == 1;}) && responses == 0);
  rclcpp::spin_until_future_complete(node, future);
  check("and its response", comes([&] {return responses == 1;}));
  service->clear_on_new_request_callback();
  client->clear_on_new_response_callback();
  auto again = client->async_send_request(std::make_shared<AddTwoInts::Request>());
  rclcpp::spin_until_future_complete(node, again);
  equal("both may be cleared", requests + responses, 2u);
  equal("a service's empty one", text_of([&] {service->set_on_new_request_callback(nullptr);}),
    "The callback passed to set_on_new_request_callback is not callable.");
  equal("a client's empty one", text_of([&] {client->set_on_new_response_callback(nullptr);}),
    "The callback passed to set_on_new_response_callback is not callable.");
}

void events(rclcpp::Node::SharedPtr node)
{
  std::atomic<size_t> offered{0}, requested{0}, lost{0};
  rclcpp::PublisherOptions options;
  options.event_callbacks.incompatible_qos_callback = [](rclcpp::QOSOfferedIncompatibleQoSInfo &) {};
  auto publisher = node->create_publisher<Int32>("strict", rclcpp::QoS(1).best_effort(), options);
  publisher->set_on_new_qos_event_callback([&](size_t n) {offered += n;}, RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS);
  auto subscription = node->create_subscription<Int32>("strict", 1, [](const Int32 &) {});
  auto kind = RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS;
  subscription->set_on_new_qos_event_callback([&](size_t n) {requested += n;}, kind);
  check("a publisher's event is told", comes([&] {return offered == 1;}));
  check("a subscription's that has happened", comes([&] {return requested == 1;}));
  subscription->clear_on_new_qos_event_callback(kind);
  publisher->clear_on_new_qos_event_callback(RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS);
  auto another = node->create_subscription<Int32>("strict", 1, [](const Int32 &) {});
  rclcpp::sleep_for(30ms);
  equal("events may be cleared", offered.load(), 1u);
  subscription->set_on_new_qos_event_callback([&](size_t n) {lost += n;}, RCL_SUBSCRIPTION_MESSAGE_LOST);
  equal("one without a handler is only warned of", lost.load(), 0u);
  equal("an event's empty one", text_of([&] {subscription->set_on_new_qos_event_callback(nullptr, kind);}),
    "The callback passed to set_on_new_qos_event_callback is not callable.");
}

void in_program()
{
  auto options = rclcpp::NodeOptions().use_intra_process_comms(true);
  auto node = rclcpp::Node::make_shared("inside", options), other = rclcpp::Node::make_shared("outside");
  auto subscription = node->create_subscription<Int32>("near", 10, [](Int32::UniquePtr) {});
  auto near = node->create_publisher<Int32>("near", 10), far = other->create_publisher<Int32>("near", 10);
  std::atomic<size_t> inside{0}, outside{0};
  subscription->set_on_new_intra_process_message_callback([&](size_t count) {inside += count;});
  subscription->set_on_new_message_callback([&](size_t count) {outside += count;});
  near->publish(std::make_unique<Int32>());
  check("what stays in the program is told apart", comes([&] {return inside == 1;}) && outside == 0);
  far->publish(Int32());
  check("from what comes from elsewhere", comes([&] {return outside == 1;}) && inside == 1);
  subscription->clear_on_new_intra_process_message_callback();
  near->publish(std::make_unique<Int32>());
  rclcpp::sleep_for(30ms);
  equal("that may be cleared too", inside.load(), 1u);
  equal("and wants a callback", text_of([&] {subscription->set_on_new_intra_process_message_callback(nullptr);}),
    "The callback passed to set_on_new_intra_process_message_callback is not callable.");
}

void actions(rclcpp::Node::SharedPtr node)
{
  using Server = rclcpp_action::Server<Fibonacci>;
  using Client = rclcpp_action::Client<Fibonacci>;
  auto server = rclcpp_action::create_server<Fibonacci>(
    node, "count", [](auto &, auto) {return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;},
    [](auto) {return rclcpp_action::CancelResponse::ACCEPT;},
    [](std::shared_ptr<Server::Handle> handle) {
      handle->publish_feedback(std::make_shared<Fibonacci::Feedback>());
      handle->succeed(std::make_shared<Fibonacci::Result>());
    });
  auto client = rclcpp_action::create_client<Fibonacci>(node, "count");
  std::atomic<size_t> asked[3] = {}, answered[5] = {};
  server->set_on_ready_callback([&](size_t count, int kind) {asked[kind] += count;});
  client->set_on_ready_callback([&](size_t count, int kind) {answered[kind] += count;});
  auto goal = client->async_send_goal(Fibonacci::Goal());
  auto goals = static_cast<size_t>(Server::EntityType::GoalService);
  check("an action server is told of a goal", comes([&] {return asked[goals] == 1;}));
  rclcpp::spin_until_future_complete(node, goal);
  rclcpp::spin_until_future_complete(node, client->async_get_result(goal.get()));
  auto of = [&](Client::EntityType kind) {return answered[static_cast<size_t>(kind)].load();};
  check("its client of the answer", comes([&] {return of(Client::EntityType::GoalClient) == 1;}));
  check("of feedback", comes([&] {return of(Client::EntityType::FeedbackSubscription) == 1;}));
  check("of the result", comes([&] {return of(Client::EntityType::ResultClient) == 1;}));
  check("and of how it stands", of(Client::EntityType::StatusSubscription) > 0);
  equal("but not of what nobody asked", of(Client::EntityType::CancelClient), 0u);
  server->clear_on_ready_callback();
  client->clear_on_ready_callback();
  rclcpp::spin_until_future_complete(node, client->async_send_goal(Fibonacci::Goal()));
  equal("an action's may be cleared", asked[goals].load(), 1u);
  equal("an action's empty one", text_of([&] {client->set_on_ready_callback(nullptr);}),
    "The callback passed to set_on_ready_callback is not callable.");
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("listener");
  topics(node);
  services(node);
  events(node);
  in_program();
  actions(node);
  auto guard = std::make_shared<rclcpp::GuardCondition>();
  size_t raised = 0;
  guard->trigger();
  guard->trigger();
  guard->set_on_trigger_callback([&](size_t count) {raised += count;});
  equal("a guard condition tells what was before", raised, 2u);
  guard->trigger();
  equal("and each trigger", raised, 3u);
  rclcpp::shutdown();
}
