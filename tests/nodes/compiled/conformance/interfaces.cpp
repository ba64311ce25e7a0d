// A node's interfaces one by one, and the free functions that make entities of them.
#include "check.hpp"
#include "rclcpp/create_generic_publisher.hpp"
#include "rclcpp/create_generic_subscription.hpp"
#include "std_msgs/msg/int32.hpp"
#include "std_srvs/srv/trigger.hpp"

using std_msgs::msg::Int32;
using std_srvs::srv::Trigger;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("parts", "/of", rclcpp::NodeOptions(rcl_get_default_allocator()));
  auto base = node->get_node_base_interface();
  rcl_node_t * handle = base->get_rcl_node_handle();
  equal("a handle's name", std::string(rcl_node_get_name(handle)), "parts");
  equal("a handle's namespace", std::string(rcl_node_get_namespace(handle)), "/of");
  equal("a handle's full name", std::string(rcl_node_get_fully_qualified_name(handle)), "/of/parts");
  equal("a handle's logger", std::string(rcl_node_get_logger_name(handle)), "of.parts");
  check("a handle is valid", rcl_node_is_valid(handle) && !rcl_node_is_valid(nullptr));
  check("a shared handle is the same", base->get_shared_rcl_node_handle().get() == handle);
  equal("a topic's name in full", base->resolve_topic_or_service_name("x", false), "/of/x");
  equal("a service's name in full", base->resolve_topic_or_service_name("~/x", true), "/of/parts/x");

  // topics
  auto topics = node->get_node_topics_interface();
  auto parameters = node->get_node_parameters_interface();
  std::vector<int> heard;
  auto keep = [&](const Int32 & message) {heard.push_back(message.data);};
  auto first = rclcpp::create_subscription<Int32>(topics, "number", 10, keep);
  auto second = rclcpp::create_subscription<Int32>(parameters, topics, "number", 10, keep, rclcpp::SubscriptionOptions());
  auto publisher = rclcpp::create_publisher<Int32>(parameters, topics, "number", 10, rclcpp::PublisherOptions());
  size_t bytes = 0;
  auto raw = rclcpp::create_generic_subscription(
    topics, "number", "std_msgs/msg/Int32", 10, [&](std::shared_ptr<rclcpp::SerializedMessage> m) {bytes = m->size();});
  check("bytes are what it hears", raw->is_serialized() && !first->is_serialized());
  publisher->publish(Int32().set__data(3));
  spin_until(node, [&] {return heard.size() == 2 && bytes;});
  check("both hear it", heard == std::vector<int>({3, 3}));
  equal("and the third its bytes", bytes, 8u);
  Int32 four;
  four.data = 4;
  rclcpp::SerializedMessage packed;
  rclcpp::Serialization<Int32>().serialize_message(&four, &packed);
  rclcpp::create_generic_publisher(topics, "number", "std_msgs/msg/Int32", 10)->publish(packed);
  spin_until(node, [&] {return heard.size() == 4;});
  equal("a generic publisher is heard", heard.back(), 4);
  rclcpp::MessageInfo info;
  Int32 taken;
  publisher->publish(Int32().set__data(5));
  check("a message is taken", first->take(taken, info));
  check("its publisher is known", *publisher == info.get_rmw_message_info().publisher_gid);
  rmw_gid_t nobody{};
  check("and is no other", !(*publisher == &nobody));

  // services
  auto services = node->get_node_services_interface();
  auto answer = [](const Trigger::Request::SharedPtr, Trigger::Response::SharedPtr response) {response->success = true;};
  auto server = rclcpp::create_service<Trigger>(base, services, "ring", answer, rclcpp::QoS(7), nullptr);
  auto graph = node->get_node_graph_interface();
  auto client = rclcpp::create_client<Trigger>(base, graph, services, "ring", rclcpp::QoS(6), nullptr);
  equal("a server's queue", server->get_request_subscription_actual_qos().depth(), 7u);
  equal("a server's other queue", server->get_response_publisher_actual_qos().depth(), 7u);
  equal("a client's queue", client->get_response_subscription_actual_qos().depth(), 6u);
  equal("a client's other queue", client->get_request_publisher_actual_qos().depth(), 6u);
  auto asked = client->async_send_request(std::make_shared<Trigger::Request>());
  check("it answers", rclcpp::spin_until_future_complete(node, asked) == rclcpp::FutureReturnCode::SUCCESS);

  // the graph
  equal("whom it publishes for", graph->get_publisher_names_and_types_by_node("parts", "/of").count("/of/number"), 1u);
  equal("what it hears", graph->get_subscriber_names_and_types_by_node("parts", "/of").at("/of/number").at(0), "std_msgs/msg/Int32");
  equal("what it serves", graph->get_service_names_and_types_by_node("parts", "/of").count("/of/ring"), 1u);
  equal("what it calls", graph->get_client_names_and_types_by_node("parts", "/of").at("/of/ring").at(0), "std_srvs/srv/Trigger");
  auto enclaves = graph->get_node_names_with_enclaves();
  check("enclaves", std::count(enclaves.begin(), enclaves.end(), std::make_tuple("parts", "/of", "/")) == 1);

  // parameters
  node->declare_parameter("arm.left", 1);
  node->declare_parameter("arm.right", "two");
  std::map<std::string, rclcpp::Parameter> arm;
  check("parameters below a prefix", parameters->get_parameters_by_prefix("arm", arm));
  check("by the rest of their names", arm.size() == 2 && arm["left"].as_int() == 1 && arm["right"].as_string() == "two");
  check("none below another", !parameters->get_parameters_by_prefix("leg", arm));
  auto judge = node->add_on_set_parameters_callback([](const std::vector<rclcpp::Parameter> &) {
        return rcl_interfaces::msg::SetParametersResult().set__successful(true).set__reason("fine");
      });
  equal("a handle has its callback", judge->callback({}).reason, "fine");
  rclcpp::AsyncParametersClient far(base, topics, graph, services, "/of/parts");
  auto got = far.get_parameters({"arm.left"});
  check("a client of the parts", rclcpp::spin_until_future_complete(node, got) == rclcpp::FutureReturnCode::SUCCESS);
  equal("asks as any", got.get().at(0).as_int(), 1);
  auto executor = std::make_shared<rclcpp::executors::SingleThreadedExecutor>();
  rclcpp::SyncParametersClient near(executor, base, topics, graph, services, "/of/parts");
  equal("one that waits", near.get_parameter<int>("arm.left"), 1);

  // timers
  auto timers = node->get_node_timers_interface();
  int rung = 0, walled = 0;
  auto alone = std::make_unique<int>(5);
  auto ring = [&rung, alone = std::move(alone)] {rung += *alone;};
  using Ringing = rclcpp::GenericTimer<decltype(ring)>;
  auto timer = std::make_shared<Ringing>(node->get_clock(), 10ms, std::move(ring), base->get_context());
  timers->add_timer(timer, nullptr);
  auto wall = rclcpp::WallTimer<std::function<void (rclcpp::TimerBase &)>>::make_shared(
    10ms, [&](rclcpp::TimerBase & me) {
      ++walled;
      me.cancel();
    }, base->get_context());
  timers->add_timer(wall, nullptr);
  check("a wall timer is steady", wall->is_steady() && !timer->is_steady());
  spin_until(node, [&] {return rung >= 10 && walled;});
  check("a timer of the program's own rings", rung >= 10);
  equal("and is told who it is", walled, 1);
  auto foreign = rclcpp::Node::make_shared("foreign")->create_callback_group(rclcpp::CallbackGroupType::Reentrant);
  throws<std::runtime_error>("not in a group of another node", [&] {timers->add_timer(timer, foreign);});

  // contexts
  auto context = base->get_context();
  equal("the domain", context->get_domain_id(), 0u);
  throws<rclcpp::exceptions::RCLError>("no domain before init", [] {rclcpp::Context().get_domain_id();});
  int ended = 0;
  auto before = context->add_pre_shutdown_callback([&] {++ended;});
  equal("callbacks are listed", context->get_pre_shutdown_callbacks().size(), 1u);
  equal("each list for itself", context->get_on_shutdown_callbacks().size(), 0u);
  check("a callback is taken back", context->remove_pre_shutdown_callback(before));
  check("which is done once", !context->remove_pre_shutdown_callback(before));
  rclcpp::shutdown();
  equal("and is not called", ended, 0);
}
