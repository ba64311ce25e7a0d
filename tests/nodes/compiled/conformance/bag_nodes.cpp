// rosbag2_transport: nodes that record topics and play bags, and what a bag says of itself.
#include "check.hpp"
#include "rosbag2_cpp/info.hpp"
#include "rosbag2_interfaces/srv/burst.hpp"
#include "rosbag2_interfaces/srv/is_paused.hpp"
#include "rosbag2_transport/player.hpp"
#include "rosbag2_transport/recorder.hpp"
#include "std_msgs/msg/int32.hpp"
#include "std_msgs/msg/string.hpp"

using std_msgs::msg::Int32;
using std_msgs::msg::String;

static rosbag2_storage::StorageOptions stored()
{
  rosbag2_storage::StorageOptions storage;
  storage.uri = "recorded";
  storage.storage_id = "sqlite3";
  return storage;
}
static void record(const rclcpp::Node::SharedPtr & node)
{
  rosbag2_transport::RecordOptions options;
  options.all = true;
  options.exclude = "/(rosout|parameter_events)";
  auto writer = std::make_shared<rosbag2_cpp::Writer>();
  throws<std::runtime_error>("no format", [&] {rosbag2_transport::Recorder(writer, stored(), options, "vague").record();});
  options.rmw_serialization_format = "cdr";
  auto recorder = std::make_shared<rosbag2_transport::Recorder>(writer, stored(), options);
  equal("its name", std::string(recorder->get_name()), "rosbag2_recorder");
  auto numbers = node->create_publisher<Int32>("numbers", rclcpp::QoS(10).transient_local());
  recorder->record();
  check("what there is is recorded", recorder->subscriptions().count("/numbers") == 1);
  auto words = node->create_publisher<String>("words", 10);
  check("what comes later, too", spin_until(recorder, [&] {return recorder->subscriptions().count("/words") == 1;}));
  equal("and nothing else", recorder->subscriptions().size(), 2u);
  int heard = 0;
  auto listener = node->create_subscription<Int32>("numbers", 10, [&](const Int32 &) {++heard;});
  auto say = [&](int number) {
      Int32 message;
      message.data = number;
      numbers->publish(message);
      const int before = heard;
      spin_until(node, [&] {return heard > before;});
      rclcpp::spin_some(recorder);
      rclcpp::sleep_for(20ms);  // so that they are apart in the bag
    };
  say(1);
  say(2);
  recorder->toggle_paused();
  check("it is paused", recorder->is_paused());
  say(99);
  recorder->resume();
  say(3);
  recorder->stop();
  auto found = rosbag2_cpp::Info().read_metadata("recorded", "sqlite3");
  equal("what was said while it was not paused", found.message_count, 3u);
  equal("both topics", found.topics_with_message_count.size(), 2u);
  std::string offers;
  for (auto & one : found.topics_with_message_count) {
    offers += one.topic_metadata.name == "/numbers" ? one.topic_metadata.offered_qos_profiles : "";
  }
  check("the publisher's QoS", offers.find("durability: 1\n  deadline:\n    sec: ") != offers.npos, offers);
}
static void play(const rclcpp::Node::SharedPtr & node)
{
  std::vector<int> heard;
  auto listener = node->create_subscription<Int32>(
    "numbers", rclcpp::QoS(10).transient_local(), [&](const Int32 & message) {heard.push_back(message.data);});
  rosbag2_transport::PlayOptions options;
  options.topics_to_filter = {"numbers"};
  options.wait_acked_timeout = 1000;
  auto player = std::make_shared<rosbag2_transport::Player>(
    std::make_unique<rosbag2_cpp::Reader>(), stored(), options, "player");
  std::string calls;
  auto handle = player->add_on_play_message_pre_callback([&](auto) {calls += "<";});
  player->add_on_play_message_post_callback([&](auto message) {calls += message->topic_name == "/numbers" ? ">" : "?";});
  rclcpp::Clock steady(RCL_STEADY_TIME);
  auto before = steady.now();
  player->play();
  check("all are played, by QoS of the recorded ones", spin_until(node, [&] {return heard == std::vector<int>{1, 2, 3};}));
  check("it takes its time", steady.now() - before >= rclcpp::Duration(40ms));
  equal("called before and after each", calls, "<><><>");
  check("not once more", spin_until(player, [&] {return !player->is_paused();}) && player->get_rate() == 1.0);
  check("not at any rate", !player->set_rate(0) && !player->set_rate(-2) && player->set_rate(50) && player->get_rate() == 50);
  check("nothing next while it plays", !player->play_next() && player->burst(1) == 0);
  player->delete_on_play_message_callback(handle);
  player->pause();
  player->seek(0);
  heard.clear();
  calls.clear();
  check("the next one while it is paused", player->play_next());
  equal("one is called after, none before", calls, ">");
  check("that is all", spin_until(node, [&] {return heard == std::vector<int>{1};}));

  using rosbag2_interfaces::srv::Burst;
  auto client = node->create_client<Burst>("player/burst");
  rclcpp::executors::SingleThreadedExecutor both;
  both.add_node(node);
  both.add_node(player);
  auto request = std::make_shared<Burst::Request>();
  request->num_messages = 5;
  auto future = client->async_send_request(request);
  check("a service", both.spin_until_future_complete(future, 5s) == rclcpp::FutureReturnCode::SUCCESS);
  equal("all that were left", future.get()->actually_burst, 2u);
  check("there is none", !player->play_next());
  auto kind = node->create_client<rosbag2_interfaces::srv::IsPaused>("player/is_paused");
  auto paused = kind->async_send_request(std::make_shared<rosbag2_interfaces::srv::IsPaused::Request>());
  both.spin_until_future_complete(paused, 5s);
  check("it says that it is paused", paused.get()->paused);
}
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("around");
  record(node);
  play(node);
  throws<std::runtime_error>("no bag", [] {rosbag2_cpp::Info().read_metadata("nowhere");});
  rclcpp::shutdown();
}
