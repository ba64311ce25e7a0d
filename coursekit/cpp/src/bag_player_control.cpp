// What is done to a player: it is paused, made faster, and sent elsewhere in its bag, by a program or by services.
#include <cmath>

#include "rosbag2_interfaces/srv/burst.hpp"
#include "rosbag2_interfaces/srv/get_rate.hpp"
#include "rosbag2_interfaces/srv/is_paused.hpp"
#include "rosbag2_interfaces/srv/pause.hpp"
#include "rosbag2_interfaces/srv/play_next.hpp"
#include "rosbag2_interfaces/srv/resume.hpp"
#include "rosbag2_interfaces/srv/seek.hpp"
#include "rosbag2_interfaces/srv/set_rate.hpp"
#include "rosbag2_interfaces/srv/toggle_paused.hpp"
#include "rosbag2_transport/player.hpp"

namespace rosbag2_transport
{
void Player::make_services()
{
  namespace srv = rosbag2_interfaces::srv;
#define COURSEKIT_SERVE(Kind, name, act) \
  services_.push_back( \
    create_service<srv::Kind>( \
      "~/" name, [this](const srv::Kind::Request::SharedPtr request, srv::Kind::Response::SharedPtr response) { \
        (void)request; \
        (void)response; \
        act; \
      }))
  COURSEKIT_SERVE(Pause, "pause", pause());
  COURSEKIT_SERVE(Resume, "resume", resume());
  COURSEKIT_SERVE(TogglePaused, "toggle_paused", toggle_paused());
  COURSEKIT_SERVE(IsPaused, "is_paused", response->paused = is_paused());
  COURSEKIT_SERVE(GetRate, "get_rate", response->rate = get_rate());
  COURSEKIT_SERVE(SetRate, "set_rate", response->success = set_rate(request->rate));
  COURSEKIT_SERVE(PlayNext, "play_next", response->success = play_next());
  COURSEKIT_SERVE(Burst, "burst", response->actually_burst = burst(request->num_messages));
  COURSEKIT_SERVE(Seek, "seek", seek(rclcpp::Time(request->time).nanoseconds()); response->success = true);
#undef COURSEKIT_SERVE
}
int64_t Player::position() const
{
  std::lock_guard<std::recursive_mutex> hold(lock_);
  return paused_ ? there_ : there_ + static_cast<int64_t>(static_cast<double>(coursekit::steady_now() - here_) * rate_);
}
void Player::jump(int64_t position)
{
  here_ = coursekit::steady_now();
  there_ = position;
}
void Player::pause()
{
  std::lock_guard<std::recursive_mutex> hold(lock_);
  jump(position());
  paused_ = true;
  RCLCPP_INFO(get_logger(), "Pausing play.");
}
void Player::resume()
{
  std::lock_guard<std::recursive_mutex> hold(lock_);
  jump(position());
  paused_ = false;
  RCLCPP_INFO(get_logger(), "Resuming play.");
}
void Player::toggle_paused()
{
  std::lock_guard<std::recursive_mutex> hold(lock_);
  paused_ ? resume() : pause();
}
bool Player::is_paused() const
{
  std::lock_guard<std::recursive_mutex> hold(lock_);
  return paused_;
}
double Player::get_rate() const
{
  std::lock_guard<std::recursive_mutex> hold(lock_);
  return rate_;
}
bool Player::set_rate(double rate)
{
  std::lock_guard<std::recursive_mutex> hold(lock_);
  if (!(rate > 0) || !std::isfinite(rate)) {
    RCLCPP_WARN(get_logger(), "Failed to set rate to invalid value %g", rate);
    return false;
  }
  jump(position());
  rate_ = rate;
  RCLCPP_INFO(get_logger(), "Set rate to %g", rate);
  return true;
}
bool Player::skip_to_next()
{
  int64_t wait = 0;
  while (Message message = take(true, wait)) {
    {
      std::lock_guard<std::recursive_mutex> hold(lock_);
      jump(message->time_stamp);
    }
    if (publish(message)) {
      return true;
    }
  }
  return false;
}
bool Player::play_next()
{
  if (!is_paused()) {
    RCLCPP_WARN(get_logger(), "Called play next, but not in paused state.");
    return false;
  }
  return skip_to_next();
}
size_t Player::burst(const size_t num_messages)
{
  if (!is_paused()) {
    RCLCPP_WARN(get_logger(), "Burst can only be used when in the paused state.");
    return 0;
  }
  size_t played = 0;
  while ((num_messages == 0 || played < num_messages) && skip_to_next()) {
    ++played;
  }
  RCLCPP_INFO(get_logger(), "Burst %zu messages.", played);
  return played;
}
void Player::seek(rcutils_time_point_value_t time_point)
{
  std::lock_guard<std::recursive_mutex> hold(lock_);
  const int64_t time = std::max<int64_t>(time_point, start_);
  reader_->seek(time);
  next_.reset();
  jump(time);
}
}  // namespace rosbag2_transport
