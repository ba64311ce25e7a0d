// A camera's calibration: loaded from its URL when it is asked for, set by the service set_camera_info.
#pragma once
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <string>

#include "ament_index_cpp/get_package_share_directory.hpp"
#include "camera_calibration_parsers/parse.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/srv/set_camera_info.hpp"

namespace camera_info_manager
{
using CameraInfo = sensor_msgs::msg::CameraInfo;
using SetCameraInfo = sensor_msgs::srv::SetCameraInfo;
/// Where a calibration is kept that has no other place.
inline const std::string default_camera_info_url = "file://${ROS_HOME}/camera_info/${NAME}.yaml";  // NOLINT

class CameraInfoManager
{
public:
  template<class N, class = decltype(std::declval<N &>().get_node_base_interface())>
  CameraInfoManager(  // NOLINT: one word is enough, as Humble's
    N * node, const std::string & cname = "camera", const std::string & url = "")
  : CameraInfoManager(
      node->get_node_base_interface(), node->get_node_services_interface(), node->get_node_logging_interface(), cname, url) {}
  CameraInfoManager(
    rclcpp::node_interfaces::NodeBaseInterface::SharedPtr base,
    rclcpp::node_interfaces::NodeServicesInterface::SharedPtr services,
    rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr logging, const std::string & cname = "camera",
    const std::string & url = "", rmw_qos_profile_t custom_qos = rmw_qos_profile_default)
  : logger_(logging->get_logger()), name_(cname), url_(url)
  {
    service_ = rclcpp::create_service<SetCameraInfo>(
      base, services, "~/set_camera_info",
      [this](std::shared_ptr<SetCameraInfo::Request> request, std::shared_ptr<SetCameraInfo::Response> response) {
        set(request->camera_info, *response);
      }, custom_qos, nullptr);
  }

  /// The calibration without a header; all zeros where there is none.
  CameraInfo getCameraInfo()
  {
    load_once();
    std::lock_guard<std::mutex> turn(lock_);
    return info_;
  }
  bool isCalibrated() {return getCameraInfo().k[0] != 0.0;}
  /// Load from another place; whether there is a calibration.
  bool loadCameraInfo(const std::string & url)
  {
    {
      std::lock_guard<std::mutex> turn(lock_);
      url_ = url;
      loaded_ = true;
    }
    return load(url);
  }
  std::string resolveURL(const std::string & url, const std::string & cname)
  {
    std::string whole;
    for (size_t at = 0; at < url.size(); ) {
      if (url.compare(at, 7, "${NAME}") == 0) {
        whole += cname;
        at += 7;
      } else if (url.compare(at, 11, "${ROS_HOME}") == 0) {
        whole += ros_home();
        at += 11;
      } else {
        if (url.compare(at, 2, "${") == 0) {
          RCLCPP_ERROR(logger_, " invalid URL substitution (not resolved): %s", url.c_str());
        }
        whole += url[at++];
      }
    }
    return whole;
  }
  /// Another name, of letters, digits and _; the calibration is loaded anew before it is used again.
  bool setCameraName(const std::string & cname)
  {
    for (unsigned char one : cname) {
      if (!std::isalnum(one) && one != '_') {
        return false;
      }
    }
    std::lock_guard<std::mutex> turn(lock_);
    name_ = cname.empty() ? name_ : cname;
    loaded_ = loaded_ && cname.empty();
    return !cname.empty();
  }
  bool setCameraInfo(const CameraInfo & camera_info)
  {
    std::lock_guard<std::mutex> turn(lock_);
    info_ = camera_info;
    loaded_ = true;
    return true;
  }
  bool validateURL(const std::string & url) {return kind(resolveURL(url, name_)) != INVALID;}

private:
  enum Kind {EMPTY, FILE_URL, PACKAGE, INVALID};

  static std::string ros_home()
  {
    const char * home = std::getenv("ROS_HOME");
    if (home) {
      return home;
    }
    home = std::getenv("HOME");
    return home ? std::string(home) + "/.ros" : "";
  }
  static Kind kind(const std::string & url)
  {
    std::string begin;
    for (unsigned char one : url.substr(0, 10)) {
      begin += static_cast<char>(std::tolower(one));
    }
    size_t rest = url.find('/', 10);
    bool has_path = rest != std::string::npos && rest > 10 && rest + 1 < url.size();
    return url.empty() ? EMPTY : begin.rfind("file:///", 0) == 0 ? FILE_URL : begin == "package://" && has_path ? PACKAGE : INVALID;
  }
  /// The file that a URL means; empty where it means none, which is said.
  std::string path_of(const std::string & url)
  {
    if (kind(url) == FILE_URL) {
      return url.substr(7);
    }
    size_t rest = url.find('/', 10);
    std::string package = url.substr(10, rest - 10);
    try {
      return ament_index_cpp::get_package_share_directory(package) + url.substr(rest);
    } catch (const ament_index_cpp::PackageNotFoundError &) {
      RCLCPP_WARN(logger_, "unknown package: %s (ignored)", package.c_str());
      return "";
    }
  }
  void load_once()
  {
    std::string url;
    {
      std::lock_guard<std::mutex> turn(lock_);
      if (loaded_) {
        return;
      }
      loaded_ = true;
      url = url_;
    }
    load(url);
  }
  bool load(const std::string & url)
  {
    std::string place = resolveURL(url, name_);
    if (kind(place) == EMPTY) {
      RCLCPP_INFO(logger_, "using default calibration URL");
      return load(default_camera_info_url);
    }
    RCLCPP_INFO(logger_, "camera calibration URL: %s", place.c_str());
    if (kind(place) == INVALID) {
      RCLCPP_ERROR(logger_, "Invalid camera calibration URL: %s", place.c_str());
      return false;
    }
    std::string path = path_of(place);
    return !path.empty() && load_file(path);
  }
  bool load_file(const std::string & path)
  {
    std::string name;
    CameraInfo info;
    if (!camera_calibration_parsers::readCalibration(path, name, info)) {
      RCLCPP_WARN(logger_, "Camera calibration file %s not found", path.c_str());
      return false;
    }
    if (name != name_) {
      RCLCPP_WARN(logger_, "[%s] does not match %s in file %s", name_.c_str(), name.c_str(), path.c_str());
    }
    setCameraInfo(info);
    return true;
  }
  bool save(const CameraInfo & info, const std::string & url)
  {
    std::string place = resolveURL(url, name_);
    if (kind(place) == INVALID) {
      RCLCPP_ERROR(logger_, "invalid url: %s (ignored)", place.c_str());
    }
    if (kind(place) == EMPTY || kind(place) == INVALID) {
      return save(info, default_camera_info_url);
    }
    std::string path = path_of(place);
    if (path.empty()) {
      return false;
    }
    RCLCPP_INFO(logger_, "writing calibration data to %s", path.c_str());
    std::error_code failed;
    std::filesystem::create_directories(std::filesystem::path(path).parent_path(), failed);
    return camera_calibration_parsers::writeCalibration(path, name_, info);
  }
  void set(const CameraInfo & info, SetCameraInfo::Response & response)
  {
    setCameraInfo(info);
    response.success = save(info, url_);
    if (!response.success) {
      response.status_message = "Error storing camera calibration.";
    }
  }

  rclcpp::Logger logger_;
  std::mutex lock_;
  std::string name_, url_;
  CameraInfo info_;
  bool loaded_ = false;
  rclcpp::Service<SetCameraInfo>::SharedPtr service_;
};
}  // namespace camera_info_manager
