#include "check.hpp"
#include "example_interfaces/srv/add_two_ints.hpp"
#include "std_msgs/msg/int32.hpp"

using example_interfaces::srv::AddTwoInts;
using std_msgs::msg::Int32;
using Kind = rclcpp::WaitResultKind;

template<class Set, class = void>
struct TakesTimers : std::false_type {};
template<class Set>
struct TakesTimers<Set, std::void_t<decltype(std::declval<Set &>().add_timer(rclcpp::TimerBase::SharedPtr()))>>
: std::true_type {};
/// What is not possible, and the words in which it is said.
template<class F>
void refuses(const std::string & name, const std::string & words, F what)
{
  try {
    what();
  } catch (const std::runtime_error & error) {
    return equal(name, error.what(), words);
  }
  check(name, false, "threw nothing");
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("waiter");
  auto first = node->create_subscription<Int32>("number", 10, [](Int32::UniquePtr) {});
  auto second = node->create_subscription<Int32>("number", 10, [](Int32::UniquePtr) {});
  auto guard = std::make_shared<rclcpp::GuardCondition>();
  auto publisher = node->create_publisher<Int32>("number", 1);
  rclcpp::WaitSet set({}, std::vector<rclcpp::GuardCondition::SharedPtr>{guard});
  set.add_subscription(first);
  set.add_subscription(second);
  throws<std::runtime_error>("added twice", [&] {set.add_subscription(first);});
  throws<std::invalid_argument>("nothing removed", [&] {set.remove_guard_condition(nullptr);});
  throws<std::invalid_argument>("nothing added", [&] {set.add_subscription(nullptr);});
  check("nothing comes", set.wait(20ms).kind() == Kind::Timeout);
  auto context = rclcpp::contexts::get_global_default_context();
  auto unused = std::make_shared<rclcpp::GuardCondition>(context);
  check("a set of a context", rclcpp::WaitSet({}, {unused}, {}, {}, {}, {}, context).wait(1ms).kind() == Kind::Timeout);
  throws<std::invalid_argument>("of none", [&] {rclcpp::WaitSet({}, {}, {}, {}, {}, {}, nullptr);});
  throws<rclcpp::exceptions::RCLInvalidArgument>(
    "of one that has not begun", [&] {rclcpp::ThreadSafeWaitSet({}, {}, {}, {}, {}, {}, std::make_shared<rclcpp::Context>());});
  guard->trigger();
  auto result = set.wait(1s);
  check("a guard condition ends the wait", result.kind() == Kind::Ready);
  check("it is told", result.get_wait_set().get_rcl_wait_set().guard_conditions[0] != nullptr);
  check("and nothing else", result.get_wait_set().get_rcl_wait_set().subscriptions[0] == nullptr);
  check("it is lowered", set.wait(20ms).kind() == Kind::Timeout);
  throws<std::runtime_error>("a timeout has no set", [&] {(void)set.wait(1ms).get_wait_set();});
  publisher->publish(Int32().set__data(4));
  auto came = set.wait(1s);
  check("a message ends it", came.kind() == Kind::Ready);
  equal("there are two subscriptions", came.get_wait_set().get_rcl_wait_set().size_of_subscriptions, 2u);
  check("both are ready", set.get_rcl_wait_set().subscriptions[0] && set.get_rcl_wait_set().subscriptions[1]);
  Int32 message;
  rclcpp::MessageInfo info;
  check("it is taken", first->take(message, info) && message.data == 4);
  check("once", !first->take(message, info));
  check("the other has its own", second->take(message, info));
  set.remove_subscription(second);
  throws<std::runtime_error>("removed twice", [&] {set.remove_subscription(second);});
  equal("one is left", set.get_rcl_wait_set().size_of_subscriptions, 1u);
  rclcpp::WaitSet other;
  check("an empty one", other.wait(1s).kind() == Kind::Empty);
  throws<std::runtime_error>("a guard condition is in one set", [&] {other.add_guard_condition(guard);});
  int rung = 0;
  auto timer = node->create_wall_timer(20ms, [&] {++rung;});
  rclcpp::WaitSet timers({}, {}, {timer});
  check("a timer ends it", timers.wait(1s).kind() == Kind::Ready);
  check("it is called by hand", timer->call());
  timer->execute_callback();
  equal("and its callback", rung, 1);
  std::thread raise([&] {
      rclcpp::sleep_for(50ms);
      guard->trigger();
    });
  check("another thread ends it", set.wait().kind() == Kind::Ready);
  raise.join();
  using Fixed = rclcpp::StaticWaitSet<1, 1, 0, 0, 0, 0>;
  auto own_guard = std::make_shared<rclcpp::GuardCondition>();
  Fixed fixed(
    std::array<Fixed::SubscriptionEntry, 1>{{{second}}}, std::array<rclcpp::GuardCondition::SharedPtr, 1>{{own_guard}},
    std::array<rclcpp::TimerBase::SharedPtr, 0>{}, std::array<rclcpp::ClientBase::SharedPtr, 0>{},
    std::array<rclcpp::ServiceBase::SharedPtr, 0>{}, std::array<Fixed::WaitableEntry, 0>{});
  own_guard->trigger();
  check("one of fixed size", fixed.wait(1s).kind() == Kind::Ready);
  check("to which nothing can be added", TakesTimers<rclcpp::WaitSet>::value && !TakesTimers<Fixed>::value);
  rclcpp::ThreadSafeWaitSet safe;
  safe.add_timer(timer);
  throws<std::runtime_error>("a timer of two sets", [&] {rclcpp::WaitSet().add_timer(timer);});
  check("one for several threads", safe.wait(1s).kind() == Kind::Ready);
  rclcpp::ThreadSafeWaitSet grows;
  auto late = std::make_shared<rclcpp::GuardCondition>();
  std::thread adds([&] {
      rclcpp::sleep_for(30ms);
      grows.add_guard_condition(late);
      rclcpp::sleep_for(30ms);
      late->trigger();
    });
  check("what another thread adds meanwhile ends the wait", grows.wait(5s).kind() == Kind::Ready);
  check("and is told", grows.get_rcl_wait_set().size_of_guard_conditions == 1 && grows.get_rcl_wait_set().guard_conditions[0]);
  adds.join();
  std::thread removes([&] {
      rclcpp::sleep_for(30ms);
      grows.remove_guard_condition(late);
      rclcpp::sleep_for(10ms);
      late->trigger();
    });
  check("what it removes does not", grows.wait(100ms).kind() == Kind::Timeout);
  removes.join();

  // clients and services
  auto server = node->create_service<AddTwoInts>(
    "add", [](AddTwoInts::Request::SharedPtr request, AddTwoInts::Response::SharedPtr response) {
      response->sum = request->a + request->b;
    });
  auto client = node->create_client<AddTwoInts>("add");
  rclcpp::WaitSet calls({}, {}, {}, {client}, {server});
  check("nobody has asked", calls.wait(50ms).kind() == Kind::Timeout);
  auto ask = [&](int64_t a, int64_t b) {
      auto request = std::make_shared<AddTwoInts::Request>();
      request->a = a;
      request->b = b;
      return client->async_send_request(request);
    };
  auto first_sum = ask(3, 4);
  check("a request ends it", calls.wait(1s).kind() == Kind::Ready);
  check("of the service", calls.get_rcl_wait_set().services[0] && !calls.get_rcl_wait_set().clients[0]);
  AddTwoInts::Request request;
  AddTwoInts::Response response;
  auto header = server->create_request_header();
  check("the request is taken", server->take_request(request, *header) && request.a == 3);
  check("and no other", !server->take_request(request, *header));
  response.sum = 70;
  server->send_response(*header, response);
  check("a response ends it", calls.wait(1s).kind() == Kind::Ready && calls.get_rcl_wait_set().clients[0]);
  auto back = client->create_request_header();
  check("the response is taken", client->take_response(response, *back) && response.sum == 70);
  equal("it is that of the request", back->sequence_number, first_sum.request_id);
  check("and no other", !client->take_response(response, *back));
  client->handle_response(back, std::make_shared<AddTwoInts::Response>(response));
  equal("its future is fulfilled", first_sum.get()->sum, 70);
  auto second_sum = ask(5, 6);
  calls.remove_client(client);
  check("another request", calls.wait(1s).kind() == Kind::Ready && calls.get_rcl_wait_set().size_of_clients == 0);
  std::shared_ptr<void> taken = server->create_request();
  check("taken without its type", server->take_type_erased_request(taken.get(), *header));
  server->handle_request(header, taken);
  calls.remove_service(server);
  calls.add_client(client);
  check("the callback's response", calls.wait(1s).kind() == Kind::Ready && client->take_response(response, *back));
  equal("is its sum", response.sum, 11);
  rclcpp::WaitSet rival;
  refuses("a client of two sets", "client already in use by another wait set", [&] {rival.add_client(client);});
  calls.add_service(server);
  refuses("a service of two sets", "service already in use by another wait set", [&] {rival.add_service(server);});
  refuses("a subscription of two sets", "subscription already associated with a wait set", [&] {rival.add_subscription(first);});
  set.remove_subscription(first);
  rival.add_subscription(first);
  check("which one gave up", first->exchange_in_use_by_wait_set_state(first.get(), true));
  throws<std::runtime_error>("of a part it does not have", [&] {first->exchange_in_use_by_wait_set_state(&rival, true);});
  throws<std::invalid_argument>("or of nothing", [&] {first->exchange_in_use_by_wait_set_state(nullptr, true);});
  using Both = rclcpp::StaticWaitSet<0, 0, 0, 1, 1, 0>;
  Both both({}, {}, {}, {{client}}, {{server}});
  ask(1, 1);
  check("a fixed one waits for services too", both.wait(1s).kind() == Kind::Ready);
  rclcpp::shutdown();
}
