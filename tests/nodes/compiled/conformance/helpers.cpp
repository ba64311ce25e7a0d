// What drivers and controllers take beside rclcpp: buffers and publishers for real time, PID, writers of bags, who watches the graph.
#include "check.hpp"
#include "control_toolbox/pid_ros.hpp"
#include "example_interfaces/action/fibonacci.hpp"
#include "geometry_msgs/msg/polygon_stamped.hpp"
#include "image_geometry/stereo_camera_model.h"
#include "image_transport/image_transport.hpp"
#include "message_filters/pass_through.h"
#include "message_filters/sync_policies/exact_time.h"
#include "rclcpp/experimental/buffers/ring_buffer_implementation.hpp"
#include "rclcpp/graph_listener.hpp"
#include "rcpputils/filesystem_helper.hpp"
#include "realtime_tools/realtime_box.h"
#include "realtime_tools/realtime_buffer.h"
#include "realtime_tools/realtime_clock.h"
#include "realtime_tools/realtime_publisher.h"
#include "realtime_tools/realtime_server_goal_handle.h"
#include "rosbag2_compression/sequential_compression_reader.hpp"
#include "rosbag2_transport/reader_writer_factory.hpp"
#include "std_msgs/msg/int32.hpp"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

using std_msgs::msg::Int32;

static void values()
{
  realtime_tools::RealtimeBuffer<int> buffer(1);
  buffer.writeFromNonRT(2);
  equal("what is not taken yet is seen by who wrote it", *buffer.readFromNonRT(), 2);
  equal("a buffer gives its newest value", *buffer.readFromRT(), 2);
  realtime_tools::RealtimeBuffer<int> copy(buffer);
  equal("a copy of a buffer has its value", *copy.readFromRT(), 2);
  realtime_tools::RealtimeBox<std::string> box("a");
  box.set("b");
  std::string got;
  box.get(got);
  equal("a box gives what was put in", got, "b");

  rclcpp::experimental::buffers::RingBufferImplementation<int> ring(2);
  for (int i = 1; i <= 3; ++i) {
    ring.enqueue(i);
  }
  check("a ring is full with as many as it holds", ring.is_full() && ring.has_data());
  equal("a full ring has lost its oldest", ring.dequeue(), 2);
  throws<std::invalid_argument>("a ring holds something", [] {
      rclcpp::experimental::buffers::RingBufferImplementation<int> none(0);
    });
}

static void control()
{
  control_toolbox::Pid pid(1, 2, 3, 0.5, -0.5);
  equal("a command of an error and its rate", pid.computeCommand(1.0, 100000000), 1 + 0.2 + 30);
  equal("what is integrated stays within limits", pid.computeCommand(1.0, 0.0, 1000000000), 1.5);
  equal("no time, no command", pid.computeCommand(1.0, 0), 0.0);
  throws<std::invalid_argument>("limits have an order", [&] {pid.setGains(1, 1, 1, -1, 1);});
}

static void gains(const rclcpp::Node::SharedPtr & node)
{
  using rclcpp::Parameter;
  control_toolbox::PidROS loop(node, "~/arm/elbow");
  check("gains that nobody has given are told", std::isnan(node->declare_parameter("other.p", std::nan(""))) && loop.initPid());
  loop.initPid(1, 0, 0, 0, 0, false);
  node->set_parameter(Parameter("arm.elbow.p", 2.0));
  equal("a gain is a parameter", loop.getGains().p_gain_, 2.0);
  node->set_parameters({Parameter("arm.elbow.i_clamp_max", -1.0)});
  equal("limits without order are not taken", loop.getGains().i_max_, 0.0);
  loop.setGains(3, 1, 0, 5, -5, true);
  check("and gains are set as parameters", node->get_parameter("arm.elbow.i").as_double() == 1 && loop.getGains().antiwindup_);
  control_msgs::msg::PidState heard;
  auto subscription = node->create_subscription<control_msgs::msg::PidState>(
    "~/arm/elbow/pid_state", rclcpp::SensorDataQoS(), [&](const control_msgs::msg::PidState & state) {heard = state;});
  equal("a command of an error that lasted", loop.computeCommand(0.5, 0.0, rclcpp::Duration(2, 0)), 1.5 + 1.0);
  spin_until(node, [&] {return heard.output != 0;});
  check("the state is published", heard.output == 2.5 && heard.error == 0.5 && heard.timestep.sec == 2 && heard.i_max == 5);
  control_toolbox::PidROS named(node, "gains.a/b", true);
  named.initPid(1, 0, 0, 0, 0, false);
  check("a prefix for parameters keeps its slashes", node->has_parameter("gains.a/b.p"));
  const std::string topic = named.getPidStatePublisher()->get_topic_name();
  equal("and names a topic of all", topic, "/gains/a/b/pid_state");
}

static void publishing(const rclcpp::Node::SharedPtr & node)
{
  int heard = 0, sent = 0;
  auto subscription = node->create_subscription<Int32>("rt", 10, [&](Int32::ConstSharedPtr message) {heard += message->data;});
  realtime_tools::RealtimePublisher<Int32> of_nothing;
  realtime_tools::RealtimePublisher<Int32> publisher(node->create_publisher<Int32>("rt", 10));
  for (int i = 1; i <= 3; ++i) {
    if (publisher.trylock()) {
      publisher.msg_.data = i;
      publisher.unlockAndPublish();
      sent += i;
      spin_until(node, [&] {return heard == sent;});
    }
  }
  check("a thread publishes what another has filled in", sent > 0 && heard == sent);
  realtime_tools::RealtimeClock clock(node->get_clock());
  const rclcpp::Time first = clock.now(rclcpp::Time(0, 0, RCL_ROS_TIME));
  check("a clock for real time is the node's", first <= node->now() && first.nanoseconds() > 0);
}

static void graph(const rclcpp::Node::SharedPtr & node)
{
  rclcpp::graph_listener::GraphListener listener(node->get_node_base_interface()->get_context());
  listener.start_if_not_started();
  auto * one = node->get_node_graph_interface().get();
  listener.add_node(one);
  check("a listener knows its nodes", listener.is_started() && listener.has_node(one));
  throws<rclcpp::graph_listener::NodeAlreadyAddedError>("a node is added once", [&] {listener.add_node(one);});
  listener.remove_node(one);
  throws<rclcpp::graph_listener::NodeNotFoundError>("and removed once", [&] {listener.remove_node(one);});
  listener.shutdown();
  throws<rclcpp::graph_listener::GraphListenerShutdownError>("it does not begin again", [&] {listener.start_if_not_started();});
}

static void bags()
{
  rosbag2_transport::RecordOptions options;
  options.compression_mode = "file";
  options.compression_format = "zstd";
  auto writer = rosbag2_transport::ReaderWriterFactory::make_writer(options);
  writer->open("packed");
  Int32 number;
  number.data = 7;
  writer->write(number, "/number", rclcpp::Time(5, 0));
  writer->close();
  check("a bag's file is compressed", rcpputils::fs::exists("packed/packed_0.db3.zstd"));
  rosbag2_cpp::Reader reader(std::make_unique<rosbag2_compression::SequentialCompressionReader>());
  reader.open("packed");
  equal("its metadata say how", reader.get_metadata().compression_mode, "FILE");
  equal("and it is read", reader.read_next<Int32>().data, 7);
}

static void images(const rclcpp::Node::SharedPtr & node)
{
  image_transport::ImageTransport transport(node);
  equal("the transport that is always there", transport.getLoadableTransports().at(0), "image_transport/raw");
  throws<image_transport::TransportLoadException>("a transport that nobody describes", [&] {
      image_transport::create_subscription(
        node.get(), "image", [](const sensor_msgs::msg::Image::ConstSharedPtr &) {}, "nowhere");
    });
}

using geometry_msgs::msg::PolygonStamped;

static PolygonStamped::SharedPtr polygon(int32_t second)
{
  auto made = std::make_shared<PolygonStamped>();
  made->header.stamp.sec = second;
  return made;
}

static void sets()
{
  using Policy = message_filters::sync_policies::ExactTime<PolygonStamped, PolygonStamped>;
  message_filters::PassThrough<PolygonStamped> one, other;
  message_filters::Synchronizer<Policy> both(Policy(5), one, other);
  std::string said;
  both.getPolicy()->registerDropCallback(
    [&](const PolygonStamped::ConstSharedPtr & a, const PolygonStamped::ConstSharedPtr & b) {
      said += a ? "a" : "-";
      said += b ? "b" : "-";
    });
  one.add(polygon(1));
  other.add(polygon(2));
  one.add(polygon(3));
  other.add(polygon(3));
  equal("sets that are given up are told", said, "a--b");
}

static void geometry()
{
  PolygonStamped shape, moved;
  shape.polygon.points.resize(2);
  shape.polygon.points[1].x = 1;
  geometry_msgs::msg::TransformStamped up;
  up.header.frame_id = "map";
  up.transform.rotation.w = 1;
  up.transform.translation.z = 2;
  tf2::doTransform(shape, moved, up);
  check("a polygon is moved", moved.header.frame_id == "map" && moved.polygon.points[1].x == 1 && moved.polygon.points[0].z == 2);
  geometry_msgs::msg::WrenchStamped push, below;
  push.wrench.force.x = 5;
  push.wrench.torque.y = 1;
  tf2::doTransform(push, below, up);
  check("a force turns what is beside it", below.wrench.force.x == 5 && below.wrench.torque.y == 11 && below.wrench.torque.x == 0);
  geometry_msgs::msg::PoseWithCovarianceStamped pose;
  pose.pose.covariance[35] = 3;
  equal("a covariance's rows", tf2::getCovarianceMatrix(pose)[5][5], 3.0);

  sensor_msgs::msg::CameraInfo left, right;
  left.width = 640;
  left.height = 480;
  left.k = {500, 0, 320, 0, 500, 240, 0, 0, 1};
  left.p = {500, 0, 320, 0, 0, 500, 240, 0, 0, 0, 1, 0};
  right = left;
  right.p[3] = -50;  // a tenth of a metre to the right
  image_geometry::StereoCameraModel stereo;
  stereo.fromCameraInfo(left, right);
  cv::Point3d point;
  stereo.projectDisparityTo3d({370, 240}, 25, point);
  check("a disparity is a distance", stereo.baseline() == 0.1 && point.z == 2 && std::abs(point.x - 0.2) < 1e-9 && point.y == 0);
  check("and a distance a disparity", stereo.getDisparity(2) == 25 && stereo.getZ(25) == 2);
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("node");
  values();
  control();
  gains(node);
  publishing(node);
  graph(node);
  bags();
  images(node);
  sets();
  geometry();
  realtime_tools::RealtimeServerGoalHandle<example_interfaces::action::Fibonacci> * goal = nullptr;
  check("a goal's handle for real time has its type", goal == nullptr);
  rclcpp::shutdown();
}
