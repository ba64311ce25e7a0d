// The node that records a bag.
#pragma once
#include <memory>
#include <regex>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "rosbag2_cpp/writer.hpp"
#include "rosbag2_storage/storage_options.hpp"
#include "rosbag2_transport/record_options.hpp"

namespace rosbag2_transport
{
/// Subscribes to topics as they appear, and writes their messages while an executor spins it.
class Recorder : public rclcpp::Node
{
public:
  explicit Recorder(
    const std::string & node_name = "rosbag2_recorder", const rclcpp::NodeOptions & node_options = rclcpp::NodeOptions());
  Recorder(
    std::shared_ptr<rosbag2_cpp::Writer> writer, const rosbag2_storage::StorageOptions & storage_options,
    const RecordOptions & record_options, const std::string & node_name = "rosbag2_recorder",
    const rclcpp::NodeOptions & node_options = rclcpp::NodeOptions());
  ~Recorder() override;

  /// Open the bag and begin; std::runtime_error where the options name no format of messages.
  void record();
  /// Stop, and close the bag.
  void stop();
  void pause();
  void resume();
  void toggle_paused();
  bool is_paused() {return paused_;}
  /// Topics with publishers that the subscription does not fit.
  const std::unordered_set<std::string> & topics_using_fallback_qos() const {return topics_warned_about_incompatibility_;}
  const std::unordered_map<std::string, std::shared_ptr<rclcpp::SubscriptionBase>> & subscriptions() const {return subscriptions_;}
  const rosbag2_cpp::Writer & get_writer_handle() {return *writer_;}

private:
  void discover();
  bool takes(const std::string & name, const std::vector<std::string> & types);
  bool refuse(const std::string & key, const std::string & text);
  void subscribe(const std::string & name, const std::string & type);
  void keep(const std::string & name, const std::string & type, const rclcpp::SerializedMessage & message);
  void warn_of_new_publishers(const std::string & name);

  std::shared_ptr<rosbag2_cpp::Writer> writer_;
  rosbag2_storage::StorageOptions storage_options_;
  RecordOptions record_options_;
  std::unordered_set<std::string> requested_, refused_, topics_warned_about_incompatibility_;
  std::unordered_map<std::string, std::shared_ptr<rclcpp::SubscriptionBase>> subscriptions_;
  rclcpp::ServiceBase::SharedPtr snapshot_;
  rclcpp::TimerBase::SharedPtr discovery_;
  std::atomic<bool> paused_{false};
};
}  // namespace rosbag2_transport
