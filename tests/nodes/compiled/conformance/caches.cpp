// tf2's caches and numbers, clouds' fields, the index, filters' names.
#include "ament_index_cpp/get_packages_with_prefixes.hpp"
#include "ament_index_cpp/get_search_paths.hpp"
#include "check.hpp"
#include "image_transport/subscriber_filter.hpp"
#include "message_filters/null_types.h"
#include "sensor_msgs/point_cloud2_iterator.hpp"
#include "sensor_msgs/point_cloud_conversion.hpp"
#include "tf2/LinearMath/QuadWord.h"
#include "tf2/LinearMath/Transform.h"
#include "tf2/buffer_core.h"
#include "tf2/time_cache.h"
#include "tf2_ros/create_timer_interface.h"

static tf2::TransformStorage item(int64_t nanoseconds, uint32_t frame, double x = 0, const tf2::Quaternion & turn = {0, 0, 0, 1})
{
  return {tf2::TimePoint(std::chrono::nanoseconds(nanoseconds)), turn, {x, 0, 0}, frame, 0};
}
static tf2::TimePoint at(int64_t nanoseconds) {return tf2::TimePoint(std::chrono::nanoseconds(nanoseconds));}

struct Open : tf2::TimeCache
{
  using tf2::TimeCache::TimeCache;
  using tf2::TimeCache::getAllItems;
  std::string frames() const
  {
    std::string all;
    for (auto & one : getAllItems()) {
      all += std::to_string(one.frame_id_);
    }
    return all;
  }
};

static void orders()
{
  Open cache(std::chrono::nanoseconds(10));
  for (auto & one : {item(0, 0), item(10, 1), item(5, 2), item(3, 3), item(8, 4), item(8, 5), item(8, 6)}) {
    cache.insertData(one);
  }
  equal("the newest first, of one time the last that came", cache.frames(), "1654230");
  check("the same again is not kept", !cache.insertData(item(8, 4)) && cache.getListLength() == 7);
  cache.insertData(item(15, 7));
  check("too old", !cache.insertData(item(0, 8)));
  cache.insertData(item(5, 9));
  equal("what is older than the span goes", cache.frames(), "7165492");
  check("its times", cache.getLatestTimestamp() == at(15) && cache.getOldestTimestamp() == at(5));
  check("the newest and its parent", cache.getLatestTimeAndParent() == tf2::P_TimeAndFrameID(at(15), 7));
  cache.clearList();
  equal("nothing left", cache.getListLength(), 0u);
}

static void between()
{
  tf2::TimeCache cache;
  tf2::TransformStorage out;
  std::string why;
  check("nothing yet", !cache.getData(at(5), out, &why) && why.find("no transforms are in the buffer") != why.npos, why);
  tf2::Quaternion turned;
  turned.setRPY(0, 0, 1);
  cache.insertData(item(100, 2, 1.0));
  check("only one", !cache.getData(at(150), out, &why) && why.find("but only time") != why.npos, why);
  cache.insertData(item(200, 2, 3.0, turned));
  check("half way", cache.getData(at(150), out) && std::abs(out.translation_.x() - 2.0) < 1e-12 && out.stamp_ == at(150));
  check("half turned", std::abs(out.rotation_.getAngle() - 0.5) < 1e-9);
  check("newest", cache.getData(tf2::TimePointZero, out) && out.translation_.x() == 3.0);
  check("future", !cache.getData(at(201), out, &why) && why.find("into the future") != why.npos, why);
  check("past", !cache.getData(at(99), out, &why) && why.find("into the past") != why.npos, why);
  cache.insertData(item(300, 5, 9.0));
  check("not across two parents", cache.getData(at(250), out) && out.translation_.x() == 3.0 && out.frame_id_ == 2);
  equal("parent", cache.getParent(at(250), nullptr), 2u);
  tf2::StaticCache always;
  always.insertData(item(1, 3, 4.0));
  check("for all times", always.getData(at(1000), out) && out.translation_.x() == 4.0 && out.stamp_ == at(1000));
}

static void maths()
{
  tf2::Vector3 v(3, -4, 1), low(1, 1, 1);
  check("axes", v.minAxis() == 1 && v.maxAxis() == 0 && v.furthestAxis() == 2 && v.closestAxis() == 1);
  v.setMax(low);
  check("the greater of both", v == tf2::Vector3(3, 1, 1));
  v *= tf2::Vector3(1, 2, 3);
  check("number by number", v == tf2::Vector3(3, 2, 3) && v / v == tf2::Vector3(1, 1, 1));
  equal("volume", tf2::tf2Triple({1, 0, 0}, {0, 2, 0}, {0, 0, 3}), 6.0);
  tf2::Quaternion turn = tf2::shortestArcQuat({1, 0, 0}, {0, 1, 0});
  check("shortest turn", (tf2::quatRotate(turn, {1, 0, 0}) - tf2::Vector3(0, 1, 0)).length() < 1e-12);
  check("turned about", (tf2::quatRotate(tf2::shortestArcQuat({1, 0, 0}, {-1, 0, 0}), {1, 0, 0}).x() + 1) < 1e-12);
  check("the nearer of two", turn.nearest(-turn) == turn && turn.farthest(turn) == -turn);
  tf2::Transform pose(turn, {1, 2, 3});
  double gl[16];
  pose.getOpenGLMatrix(gl);
  tf2::Transform again;
  again.setFromOpenGLMatrix(gl);
  check("as OpenGL has it", again == pose && gl[13] == 2 && gl[15] == 1);
  tf2::Vector3 numbers(7, 8, 9);
  numbers.m_floats[1] = 5;
  tf2Swap(numbers.m_floats[0], numbers.m_floats[2]);
  check("numbers at their places", numbers == tf2::Vector3(9, 5, 7) && numbers.w() == 0);
  equal("a fourth number", tf2::Vector4(1, -2, 3, -4).closestAxis4(), 3);
  tf2::Vector3 aside, beyond;
  tf2::tf2PlaneSpace1(tf2::Vector3(0, 0, 1), aside, beyond);
  check("a plane's axes", aside.dot(beyond) == 0 && aside.cross(beyond) == tf2::Vector3(0, 0, 1));
  equal("kept between two", GEN_clamped(5.0, 0.0, 2.0), 2.0);
  check("an angle nearer to none", tf2Equal(tf2NormalizeAngle(7.0) - 7.0 + TF2SIMD_2_PI, 1e-12));
  check("fuzzily zero", tf2FuzzyZero(1e-17) && !tf2FuzzyZero(1e-9));
  tf2::Quaternion by_z;
  by_z.setEulerZYX(0.3, 0.2, 0.1);
  double roll = 0, pitch = 0, yaw = 0;
  tf2::Matrix3x3(by_z).getEulerZYX(yaw, pitch, roll);
  check("angles about z, y, x", tf2Equal(yaw - 0.3, 1e-9) && tf2Equal(pitch - 0.2, 1e-9) && tf2Equal(roll - 0.1, 1e-9));
  check("back", (pose.invXform(pose * tf2::Vector3(4, 5, 6)) - tf2::Vector3(4, 5, 6)).length() < 1e-12);
  tf2::Matrix3x3 m(turn);
  check("transposed and timed", m.transposeTimes(m).scaled({2, 2, 2})[0].x() - 2 < 1e-12 && (m + m)[0] == m[0] * 2);
}

static void clouds()
{
  sensor_msgs::msg::PointCloud old, back;
  old.points.resize(2);
  old.points[1].y = 2.5;
  old.channels.resize(1);
  old.channels[0].name = "intensity";
  old.channels[0].values = {7, 8};
  sensor_msgs::msg::PointCloud2 cloud;
  check("as the new cloud", sensor_msgs::convertPointCloudToPointCloud2(old, cloud) && cloud.point_step == 16 && cloud.width == 2);
  equal("a field's place", sensor_msgs::getPointCloud2FieldIndex(cloud, "intensity"), 3);
  sensor_msgs::PointCloud2ConstIterator<float> first(cloud, "y"), second = first + 1;
  check("an iterator to the next point", *second == 2.5f && second != first);
  second = first.end();
  check("one to the end", !(second != first.end()) && !(++++first != second));
  check("and back", sensor_msgs::convertPointCloud2ToPointCloud(cloud, back) && back == old);
  cloud.fields[0].name = "a";
  check("no x", !sensor_msgs::convertPointCloud2ToPointCloud(cloud, back));
  unsigned char bytes[8];
  sensor_msgs::writePointCloud2BufferValue<double>(bytes, sensor_msgs::msg::PointField::INT16, -3.0);
  equal("a number of a field", sensor_msgs::readPointCloud2BufferValue<float>(bytes, sensor_msgs::msg::PointField::INT16), -3.0f);
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  orders();
  between();
  maths();
  clouds();
  auto packages = ament_index_cpp::get_packages_with_prefixes();
  check("packages", packages.count("std_msgs") == 1 && !ament_index_cpp::get_search_paths().empty());
  auto node = std::make_shared<rclcpp::Node>("camera_filter");
  image_transport::SubscriberFilter filter(node.get(), "image", "raw");
  int heard = 0;
  filter.registerCallback([&](const sensor_msgs::msg::Image::ConstSharedPtr & image) {heard += image->width;});
  auto publisher = image_transport::create_publisher(node.get(), "image");
  sensor_msgs::msg::Image image;
  image.width = 3;
  publisher.publish(image);
  check("images through a filter", spin_until(node, [&] {return heard == 3;}));
  std::shared_ptr<tf2::BufferCoreInterface> buffer = std::make_shared<tf2::BufferCore>();
  std::string why;
  check("a buffer by its interface", !buffer->canTransform("a", "b", tf2::TimePointZero, &why) && buffer->getAllFrameNames().empty());
  rclcpp::shutdown();
}
