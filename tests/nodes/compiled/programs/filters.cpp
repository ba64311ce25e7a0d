// message_filters: what belongs together, by equal and by close stamps; a cache.
#include <iostream>
#include <sstream>

#include "message_filters/cache.h"
#include "message_filters/pass_through.h"
#include "message_filters/subscriber.h"
#include "message_filters/sync_policies/approximate_epsilon_time.h"
#include "message_filters/sync_policies/approximate_time.h"
#include "message_filters/synchronizer.h"
#include "message_filters/time_synchronizer.h"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/imu.hpp"
#include "sensor_msgs/msg/range.hpp"
using sensor_msgs::msg::Imu;
using sensor_msgs::msg::Range;
using Within = message_filters::sync_policies::ApproximateEpsilonTime<Imu, Range>;
using Close = message_filters::sync_policies::ApproximateTime<Imu, Range>;

template<class M>
std::shared_ptr<M> at(int milliseconds)
{
  auto made = std::make_shared<M>();
  made->header.stamp = rclcpp::Time(milliseconds * 1000000LL);
  return made;
}
template<class M>
int64_t ms(const M & message) {return rclcpp::Time(message->header.stamp).nanoseconds() / 1000000;}

/// Which pairs an approximate synchronizer finds in "i10 r12 ...": the stamps as they come.
template<class Policy>
std::string pairs(const std::string & came, Policy policy)
{
  std::ostringstream found;
  message_filters::Synchronizer<Policy> sync(policy);
  sync.registerCallback(
    [&](const Imu::ConstSharedPtr & imu, const Range::ConstSharedPtr & range) {
      found << ms(imu) << "+" << ms(range) << " ";
    });
  std::istringstream words(came);
  for (std::string word; words >> word; ) {
    int stamp = std::stoi(word.substr(1));
    if (word[0] == 'i') {
      sync.template add<0>(at<Imu>(stamp));
    } else {
      sync.template add<1>(at<Range>(stamp));
    }
  }
  return found.str();
}
class Fusion : public rclcpp::Node
{
public:
  Fusion()
  : Node("fusion"), imu_(this, "imu"), range_(this, "range", rmw_qos_profile_sensor_data), exact_(imu_, range_, 10),
    close_(std::make_shared<message_filters::Synchronizer<Close>>(Close(10), imu_, range_)), cache_(imu_, 3)
  {
    exact_.registerCallback(std::bind(&Fusion::equal, this, std::placeholders::_1, std::placeholders::_2));
    close_->registerCallback(&Fusion::near, this);
  }
  message_filters::Cache<Imu> & cache() {return cache_;}

private:
  void equal(const Imu::ConstSharedPtr & imu, const Range::ConstSharedPtr & range)
  {
    std::cout << "equal " << ms(imu) << " " << ms(range) << std::endl;
  }
  void near(const Imu::ConstSharedPtr & imu, const Range::ConstSharedPtr & range)
  {
    std::cout << "close " << ms(imu) << " " << ms(range) << std::endl;
  }
  message_filters::Subscriber<Imu> imu_;
  message_filters::Subscriber<Range> range_;
  message_filters::TimeSynchronizer<Imu, Range> exact_;
  std::shared_ptr<message_filters::Synchronizer<Close>> close_;
  message_filters::Cache<Imu> cache_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  std::cout << pairs("i100 r103 i200 r201 i300 r309 i400 r400", Close(10)) << std::endl;
  std::cout << pairs("i100 i130 i160 r128 r190 i190", Close(10)) << std::endl;
  std::cout << pairs("i0 i10 i20 i30 r31 i40 r41", Close(3)) << std::endl;
  Close tight(10);
  tight.setMaxIntervalDuration(rclcpp::Duration::from_seconds(0.005));
  std::cout << pairs("i100 r120 i121 r200 i203 r300", tight) << std::endl;
  Close spaced(10);
  spaced.setInterMessageLowerBound(0, rclcpp::Duration::from_seconds(0.09));
  spaced.setInterMessageLowerBound(1, rclcpp::Duration::from_seconds(0.09));
  std::cout << pairs("i100 r101", Close(10)) << "|" << pairs("i100 r101", spaced) << std::endl;
  Within within(3, rclcpp::Duration::from_seconds(0.005));
  std::cout << pairs("i100 r106 i110 r114 i120 r125 i131 r140 r150 i146", within) << "|" <<
    pairs("i1 i20 i40 i60 r23", within) << std::endl;

  auto node = std::make_shared<Fusion>();
  auto imu = node->create_publisher<Imu>("imu", 10);
  auto range = node->create_publisher<Range>("range", 10);
  for (int t : {100, 200, 300, 400}) {
    imu->publish(*at<Imu>(t));
    range->publish(*at<Range>(t == 200 ? 205 : t));
  }
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.spin_all(std::chrono::nanoseconds(0));
  auto stamp = [](int t) {return rclcpp::Time(t * 1000000LL, RCL_ROS_TIME);};
  auto & cache = node->cache();
  std::cout << ms(cache.getElemBeforeTime(stamp(350))) << ms(cache.getElemAfterTime(stamp(300)))
            << cache.getInterval(stamp(200), stamp(300)).size()
            << cache.getSurroundingInterval(stamp(250), stamp(350)).size()
            << (cache.getElemBeforeTime(stamp(200)) == nullptr) << cache.getOldestTime().nanoseconds() / 1000000
            << cache.getLatestTime().nanoseconds() / 1000000 << std::endl;

  int heard = 0;
  message_filters::PassThrough<Imu> pass;
  auto connection = pass.registerCallback([&](const Imu::ConstSharedPtr &) {++heard;});
  pass.add(at<Imu>(1));
  connection.disconnect();
  pass.add(at<Imu>(2));
  std::cout << heard << std::endl;
  rclcpp::shutdown();
}
