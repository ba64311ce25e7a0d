#include "check.hpp"
#include "example_interfaces/action/fibonacci.hpp"
#include "example_interfaces/srv/add_two_ints.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

using example_interfaces::srv::AddTwoInts;
using Request = AddTwoInts::Request::SharedPtr;
using Response = AddTwoInts::Response::SharedPtr;

struct Adder
{
  void add(const Request request, Response response) {response->sum = request->a + request->b;}
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("services");
  auto client = node->create_client<AddTwoInts>("add");
  check("no service yet", !client->service_is_ready());
  check("waiting in vain", !client->wait_for_service(50ms));
  Adder adder;
  auto server = node->create_service<AddTwoInts>(
    "add", std::bind(&Adder::add, &adder, std::placeholders::_1, std::placeholders::_2));
  check("service is there", client->wait_for_service(1s) && client->service_is_ready());
  equal("service's name", std::string(server->get_service_name()), "/add");
  equal("client's name", std::string(client->get_service_name()), "/add");
  auto request = std::make_shared<AddTwoInts::Request>();
  request->a = 2;
  request->b = 3;
  auto future = client->async_send_request(request);
  check("spin until the answer", rclcpp::spin_until_future_complete(node, future) == rclcpp::FutureReturnCode::SUCCESS);
  equal("the answer", future.get()->sum, 5);
  check("an answer is taken once", !future.valid());
  std::shared_future<Response> shared = client->async_send_request(request);
  rclcpp::spin_until_future_complete(node, shared);
  equal("a shared future", shared.get()->sum + shared.get()->sum, 10);
  int64_t sum = 0;
  auto kept = client->async_send_request(
    request, [&](rclcpp::Client<AddTwoInts>::SharedFuture done) {sum = done.get()->sum;});
  spin_until(node, [&] {return sum != 0;});
  equal("a callback with the future", sum, 5);
  check("its future too", kept.wait_for(0s) == std::future_status::ready);
  sum = 0;
  client->async_send_request(
    request, [&](rclcpp::Client<AddTwoInts>::SharedFutureWithRequest done) {
      sum = done.get().first->a * 100 + done.get().second->sum;
    });
  spin_until(node, [&] {return sum != 0;});
  equal("a callback with request and answer", sum, 205);

  // without an answer
  auto nobody = node->create_client<AddTwoInts>("nobody");
  auto lost = nobody->async_send_request(request);
  check("a timeout", rclcpp::spin_until_future_complete(node, lost, 50ms) == rclcpp::FutureReturnCode::TIMEOUT);
  check("a pending request is removed", nobody->remove_pending_request(lost));
  check("only once", !nobody->remove_pending_request(lost.request_id));
  nobody->async_send_request(request);
  nobody->async_send_request(request);
  equal("all pending are pruned", nobody->prune_pending_requests(), 2u);
  auto old = nobody->async_send_request(request);
  rclcpp::sleep_for(20ms);
  std::vector<int64_t> pruned;
  equal("old ones are pruned", nobody->prune_requests_older_than(std::chrono::system_clock::now(), &pruned), 1u);
  equal("and told", pruned.at(0), old.request_id);

  // other forms of callbacks
  auto with_header = node->create_service<AddTwoInts>(
    "header", [](const std::shared_ptr<rmw_request_id_t> header, const Request q, Response r) {
      r->sum = header ? q->a : 0;
    });
  auto to_header = node->create_client<AddTwoInts>("header");
  auto headed = to_header->async_send_request(request);
  rclcpp::spin_until_future_complete(node, headed);
  equal("a callback with the request's header", headed.get()->sum, 2);
  std::shared_ptr<rmw_request_id_t> waiting;
  auto later = node->create_service<AddTwoInts>(
    "later", [&](std::shared_ptr<rclcpp::Service<AddTwoInts>>, std::shared_ptr<rmw_request_id_t> header, Request) {
      waiting = header;
    });
  auto to_later = node->create_client<AddTwoInts>("later");
  auto deferred = to_later->async_send_request(request);
  spin_until(node, [&] {return waiting != nullptr;});
  check("no answer yet", deferred.wait_for(0s) == std::future_status::timeout);
  AddTwoInts::Response answer;
  answer.sum = 99;
  later->send_response(*waiting, answer);
  rclcpp::spin_until_future_complete(node, deferred);
  equal("an answer that comes later", deferred.get()->sum, 99);
  server.reset();
  check("a service that is gone", !client->service_is_ready());

  auto short_lived = rclcpp::Node::make_shared("short_lived");
  auto widow = short_lived->create_client<AddTwoInts>("add");
  auto action_widow = rclcpp_action::create_client<example_interfaces::action::Fibonacci>(short_lived, "count");
  short_lived.reset();
  throws<rclcpp::exceptions::InvalidNodeError>("nobody waits without a node", [&] {widow->wait_for_service(0s);});
  throws<rclcpp::exceptions::InvalidNodeError>("for an action neither", [&] {action_widow->wait_for_action_server(0s);});

  // with the interfaces of a node, one by one
  auto far = rclcpp::create_service<AddTwoInts>(
    node->get_node_base_interface(), node->get_node_services_interface(), "far", [](Request q, Response r) {r->sum = q->a;},
    rmw_qos_profile_services_default, nullptr);
  auto from_far = rclcpp::create_client<AddTwoInts>(
    node->get_node_base_interface(), node->get_node_graph_interface(), node->get_node_services_interface(), "far");
  auto said = from_far->async_send_request(request);
  check("a server and a client of interfaces", rclcpp::spin_until_future_complete(node, said) == rclcpp::FutureReturnCode::SUCCESS);
  equal("who answer each other", said.get()->sum, request->a);

  // from a callback, with another group and two threads
  auto group = node->create_callback_group(rclcpp::CallbackGroupType::Reentrant);
  auto quick = node->create_service<AddTwoInts>("quick", [](Request q, Response r) {r->sum = q->a + q->b;},
      rmw_qos_profile_services_default, group);
  auto ask = node->create_client<AddTwoInts>("quick", rmw_qos_profile_services_default, group);
  int64_t nested = 0;
  rclcpp::TimerBase::SharedPtr timer;
  timer = node->create_wall_timer(10ms, [&] {
      timer->cancel();
      auto inner = ask->async_send_request(request);
      if (inner.wait_for(2s) == std::future_status::ready) {
        nested = inner.get()->sum;
      }
    });
  rclcpp::executors::MultiThreadedExecutor threads(rclcpp::ExecutorOptions(), 3);
  threads.add_node(node);
  auto stop = node->create_wall_timer(20ms, [&] {if (nested) {threads.cancel();}});
  threads.spin();
  equal("a callback waits for a service of its own node", nested, 5);
  rclcpp::shutdown();
}
