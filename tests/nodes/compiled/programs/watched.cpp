// diagnostic_updater: a publisher that is watched, a topic without headers, a heart that beats.
#include "diagnostic_updater/diagnostic_updater.hpp"
#include "diagnostic_updater/publisher.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/range.hpp"
using sensor_msgs::msg::Range;

class Sonar : public rclcpp::Node
{
public:
  Sonar()
  : Node("sonar"), updater_(this), lowest_(9), highest_(11),
    ticks_("ticks", updater_, diagnostic_updater::FrequencyStatusParam(&lowest_, &highest_, 0.1, 2)),
    range_(
      create_publisher<Range>("range", 10), updater_,
      diagnostic_updater::FrequencyStatusParam(&highest_, &highest_, 0.0, 2),
      diagnostic_updater::TimeStampStatusParam(-0.5, 0.2))
  {
    updater_.setHardwareID("sonar 1");
    updater_.add(heart_);
    timer_ = create_wall_timer(
      std::chrono::milliseconds(100), [this] {
        ticks_.tick();
        Range message;
        message.header.stamp = now() - rclcpp::Duration::from_seconds(++count_ > 20 ? 1.0 : 0.0);
        range_.publish(message);
      });
  }

private:
  diagnostic_updater::Updater updater_;
  double lowest_, highest_;
  int count_ = 0;
  diagnostic_updater::HeaderlessTopicDiagnostic ticks_;
  diagnostic_updater::DiagnosedPublisher<Range> range_;
  diagnostic_updater::Heartbeat heart_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Sonar>());
  rclcpp::shutdown();
}
