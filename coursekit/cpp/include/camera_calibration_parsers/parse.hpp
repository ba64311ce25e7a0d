// Cameras' calibrations in files, as the calibrator writes them; the session reads and writes the YAML.
#pragma once
#include <fstream>
#include <iterator>
#include <string>

#include "coursekit/link.hpp"
#include "sensor_msgs/msg/camera_info.hpp"

namespace camera_calibration_parsers
{
using CameraInfo = sensor_msgs::msg::CameraInfo;

/// Each says whether there is a calibration, or whether it could be written. Only YAML is known here.
inline bool parseCalibration(
  const std::string & buffer, const std::string & format, std::string & camera_name, CameraInfo & cam_info)
{
  if (format != "yml" && format != "yaml") {
    return false;
  }
  coursekit::Unpacker answer = coursekit::request("calibration_read", coursekit::Packer{}.s(buffer));
  if (!answer.i()) {
    return false;
  }
  camera_name = answer.s();
  cam_info = answer.m<CameraInfo>();
  return true;
}
inline bool readCalibration(const std::string & file_name, std::string & camera_name, CameraInfo & cam_info)
{
  std::ifstream file(file_name);
  std::string format = file_name.substr(file_name.rfind('.') + 1);
  return file && parseCalibration({std::istreambuf_iterator<char>(file), {}}, format, camera_name, cam_info);
}
inline bool writeCalibration(const std::string & file_name, const std::string & camera_name, const CameraInfo & cam_info)
{
  std::string format = file_name.substr(file_name.rfind('.') + 1);
  if (format != "yml" && format != "yaml") {
    return false;
  }
  std::ofstream file(file_name);
  file << coursekit::request("calibration_text", coursekit::Packer{}.s(camera_name).m(cam_info)).s();
  return static_cast<bool>(file.flush());
}
}  // namespace camera_calibration_parsers
