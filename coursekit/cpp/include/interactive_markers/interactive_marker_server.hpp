// The server of interactive markers, which RViz shows and lets people drag: nothing is sent before applyChanges().
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "visualization_msgs/msg/interactive_marker.hpp"
#include "visualization_msgs/msg/interactive_marker_feedback.hpp"
#include "visualization_msgs/msg/interactive_marker_update.hpp"
#include "visualization_msgs/srv/get_interactive_markers.hpp"

namespace interactive_markers
{
class InteractiveMarkerServer
{
public:
  using Marker = visualization_msgs::msg::InteractiveMarker;
  using Feedback = visualization_msgs::msg::InteractiveMarkerFeedback;
  using FeedbackConstSharedPtr = Feedback::ConstSharedPtr;
  using FeedbackCallback = std::function<void (FeedbackConstSharedPtr)>;
  /// In place of a kind of feedback: the callback of all kinds that have none of their own.
  static const uint8_t DEFAULT_FEEDBACK_CB = 255;

  /// For the topics NAMESPACE/update and NAMESPACE/feedback, and the service NAMESPACE/get_interactive_markers.
  InteractiveMarkerServer(
    const std::string & topic_namespace, rclcpp::node_interfaces::NodeBaseInterface::SharedPtr base,
    rclcpp::node_interfaces::NodeClockInterface::SharedPtr clock,
    rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr,
    rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr topics,
    rclcpp::node_interfaces::NodeServicesInterface::SharedPtr services,
    const rclcpp::QoS & update_pub_qos = rclcpp::QoS(100), const rclcpp::QoS & feedback_sub_qos = rclcpp::QoS(1))
  : context_(base->get_context()), clock_(clock->get_clock())
  {
    using std::placeholders::_1;
    using std::placeholders::_2;
    get_ = rclcpp::create_service<Get>(
      base, services, topic_namespace + "/get_interactive_markers",
      std::bind(&InteractiveMarkerServer::tell_all, this, _1, _2), rmw_qos_profile_services_default, nullptr);
    publisher_ = rclcpp::create_publisher<Update>(topics, topic_namespace + "/update", update_pub_qos);
    subscription_ = rclcpp::create_subscription<Feedback>(
      topics, topic_namespace + "/feedback", feedback_sub_qos,
      [this](FeedbackConstSharedPtr feedback) {take(feedback);});
  }
  template<class N>
  InteractiveMarkerServer(
    const std::string & topic_namespace, N node, const rclcpp::QoS & update_pub_qos = rclcpp::QoS(100),
    const rclcpp::QoS & feedback_sub_qos = rclcpp::QoS(1))
  : InteractiveMarkerServer(
      topic_namespace, node->get_node_base_interface(), node->get_node_clock_interface(),
      node->get_node_logging_interface(), node->get_node_topics_interface(), node->get_node_services_interface(),
      update_pub_qos, feedback_sub_qos) {}
  ~InteractiveMarkerServer()
  {
    if (rclcpp::ok(context_)) {
      clear();
      applyChanges();
    }
  }
  InteractiveMarkerServer(const InteractiveMarkerServer &) = delete;
  InteractiveMarkerServer & operator=(const InteractiveMarkerServer &) = delete;

  /// Add or replace a marker, and with a callback that of one kind of feedback or of all.
  void insert(const Marker & marker)
  {
    std::lock_guard<std::recursive_mutex> turn(lock_);
    Pending & pending = pending_[marker.name];
    pending.kind = Pending::WHOLE;
    pending.marker = marker;
  }
  void insert(const Marker & marker, FeedbackCallback callback, uint8_t kind = DEFAULT_FEEDBACK_CB)
  {
    insert(marker);
    setCallback(marker.name, callback, kind);
  }
  /// Move a marker; without a header it keeps its own. False where there is none of that name.
  bool setPose(
    const std::string & name, const geometry_msgs::msg::Pose & pose,
    const std_msgs::msg::Header & header = std_msgs::msg::Header())
  {
    std::lock_guard<std::recursive_mutex> turn(lock_);
    auto there = shown_.find(name);
    auto coming = pending_.find(name);
    bool will_be = coming != pending_.end() && coming->second.kind == Pending::WHOLE;
    if (there == shown_.end() && !will_be) {
      return false;
    }
    if (header.frame_id.empty()) {
      move(name, pose, there != shown_.end() ? there->second.marker.header : coming->second.marker.header);
    } else {
      move(name, pose, header);
    }
    return true;
  }
  /// Take a marker away; false where there is none of that name.
  bool erase(const std::string & name)
  {
    std::lock_guard<std::recursive_mutex> turn(lock_);
    if (!shown_.count(name) && !pending_.count(name)) {
      return false;
    }
    pending_[name].kind = Pending::ERASED;
    return true;
  }
  void clear()
  {
    std::lock_guard<std::recursive_mutex> turn(lock_);
    pending_.clear();
    for (auto & entry : shown_) {
      pending_[entry.first].kind = Pending::ERASED;
    }
  }
  /// Of those that are shown: what is pending does not count.
  bool empty() const {return shown_.empty();}
  std::size_t size() const {return shown_.size();}
  /// Set a marker's callback at once; an empty one takes that of its kind away. False where there is no such marker.
  bool setCallback(const std::string & name, FeedbackCallback callback, uint8_t kind = DEFAULT_FEEDBACK_CB)
  {
    std::lock_guard<std::recursive_mutex> turn(lock_);
    auto there = shown_.find(name);
    auto coming = pending_.find(name);
    if (there != shown_.end()) {
      there->second.callbacks[kind] = callback;
    }
    if (coming != pending_.end()) {
      coming->second.callbacks[kind] = callback;
    }
    return there != shown_.end() || coming != pending_.end();
  }
  /// A marker as it will be after applyChanges(); false where there will be none of that name.
  bool get(std::string name, Marker & marker) const
  {
    std::lock_guard<std::recursive_mutex> turn(lock_);
    auto there = shown_.find(name);
    auto coming = pending_.find(name);
    if (coming != pending_.end() && coming->second.kind != Pending::MOVED) {
      marker = coming->second.kind == Pending::WHOLE ? coming->second.marker : marker;
      return coming->second.kind == Pending::WHOLE;
    }
    if (there == shown_.end()) {
      return false;
    }
    marker = there->second.marker;
    if (coming != pending_.end()) {
      marker.pose = coming->second.marker.pose;
    }
    return true;
  }
  /// Send all changes since the last call to those who show the markers.
  void applyChanges()
  {
    std::lock_guard<std::recursive_mutex> turn(lock_);
    if (pending_.empty()) {
      return;
    }
    Update update;
    update.type = Update::UPDATE;
    for (auto & [name, pending] : pending_) {
      apply(name, pending, update);
    }
    pending_.clear();
    update.seq_num = ++sequence_number_;
    publisher_->publish(update);
  }

private:
  using Get = visualization_msgs::srv::GetInteractiveMarkers;
  using Update = visualization_msgs::msg::InteractiveMarkerUpdate;
  using Callbacks = std::map<uint8_t, FeedbackCallback>;
  struct Shown
  {
    Marker marker;
    Callbacks callbacks;
    rclcpp::Time last_feedback{0, 0, RCL_ROS_TIME};
    std::string last_client;
  };
  struct Pending
  {
    enum {WHOLE, MOVED, ERASED} kind = MOVED;
    Marker marker;
    Callbacks callbacks;
  };

  void move(const std::string & name, const geometry_msgs::msg::Pose & pose, const std_msgs::msg::Header & header)
  {
    Pending & pending = pending_[name];
    if (pending.kind != Pending::WHOLE) {
      pending.kind = Pending::MOVED;
    }
    pending.marker.pose = pose;
    pending.marker.header = header;
  }
  void apply(const std::string & name, Pending & pending, Update & update)
  {
    auto there = shown_.find(name);
    if (pending.kind == Pending::WHOLE) {
      if (there == shown_.end()) {
        there = shown_.emplace(name, Shown()).first;
        there->second.callbacks = pending.callbacks;
      }
      there->second.marker = pending.marker;
      update.markers.push_back(pending.marker);
    } else if (there != shown_.end() && pending.kind == Pending::MOVED) {
      Marker & marker = there->second.marker;
      marker.pose = pending.marker.pose;
      marker.header = pending.marker.header;
      update.poses.emplace_back();
      update.poses.back().set__header(marker.header).set__pose(marker.pose).set__name(marker.name);
    } else if (there != shown_.end()) {
      shown_.erase(there);
      update.erases.push_back(name);
    }
  }
  void tell_all(std::shared_ptr<Get::Request>, std::shared_ptr<Get::Response> response)
  {
    std::lock_guard<std::recursive_mutex> turn(lock_);
    response->sequence_number = sequence_number_;
    for (auto & entry : shown_) {
      response->markers.push_back(entry.second.marker);
    }
  }
  /// Who drags a marker has it for a second: what others do to it meanwhile does not count.
  void take(FeedbackConstSharedPtr feedback)
  {
    std::lock_guard<std::recursive_mutex> turn(lock_);
    auto there = shown_.find(feedback->marker_name);
    if (there == shown_.end()) {
      return;
    }
    Shown & shown = there->second;
    rclcpp::Time now(clock_->now().nanoseconds(), RCL_ROS_TIME);
    if (shown.last_client != feedback->client_id && (now - shown.last_feedback).seconds() < 1.0) {
      return;
    }
    shown.last_feedback = now;
    shown.last_client = feedback->client_id;
    if (feedback->event_type == Feedback::POSE_UPDATE) {
      bool fixed_in_time = rclcpp::Time(shown.marker.header.stamp).nanoseconds() != 0;
      move(feedback->marker_name, feedback->pose, fixed_in_time ? feedback->header : shown.marker.header);
    }
    call_back(shown.callbacks, feedback);
  }
  static void call_back(Callbacks callbacks, const FeedbackConstSharedPtr & feedback)
  {
    for (uint8_t kind : {feedback->event_type, DEFAULT_FEEDBACK_CB}) {
      auto found = callbacks.find(kind);
      if (found != callbacks.end() && found->second) {
        found->second(feedback);
        return;
      }
    }
  }

  rclcpp::Context::SharedPtr context_;
  rclcpp::Clock::SharedPtr clock_;
  mutable std::recursive_mutex lock_;
  std::map<std::string, Shown> shown_;
  std::map<std::string, Pending> pending_;
  uint64_t sequence_number_ = 0;
  rclcpp::Service<Get>::SharedPtr get_;
  rclcpp::Publisher<Update>::SharedPtr publisher_;
  rclcpp::Subscription<Feedback>::SharedPtr subscription_;
};
}  // namespace interactive_markers
