// A cv::Mat with a header, to publish and to hear as it is: between nodes of one process nothing is copied.
#pragma once
#include <cstddef>
#include <cstring>
#include <memory>
#include <opencv2/core/core.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "rclcpp/type_adapter.hpp"
#include "sensor_msgs/msg/image.hpp"

namespace cv_bridge
{
namespace detail
{
inline int mat_type_of(const std::string & encoding)
{
  static const std::pair<const char *, int> kinds[] = {
    {"mono8", CV_8UC1}, {"bgr8", CV_8UC3}, {"mono16", CV_16SC1}, {"rgba8", CV_8UC4}, {"bgra8", CV_8UC4},
    {"32FC1", CV_32FC1}, {"rgb8", CV_8UC3}, {"yuv422", CV_8UC2}};
  for (auto & kind : kinds) {
    if (encoding == kind.first) {
      return kind.second;
    }
  }
  throw std::runtime_error("Unsupported encoding type");
}
inline const char * encoding_of(int mat_type)
{
  switch (mat_type) {
    case CV_8UC1: return "mono8";
    case CV_8UC3: return "bgr8";
    case CV_16SC1: return "mono16";
    case CV_8UC4: return "rgba8";
    default: throw std::runtime_error("unsupported encoding type");
  }
}
}  // namespace detail

/// The matrix is the program's own, or shows the data of a message that is kept with it.
class ROSCvMatContainer
{
  static constexpr bool is_bigendian_system = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;
  using Image = sensor_msgs::msg::Image;
  using Header = std_msgs::msg::Header;

public:
  using SensorMsgsImageStorageType = std::variant<std::nullptr_t, std::unique_ptr<Image>, std::shared_ptr<Image>>;
  ROSCvMatContainer() = default;
  ROSCvMatContainer(ROSCvMatContainer &&) = default;
  ROSCvMatContainer & operator=(ROSCvMatContainer &&) = default;
  explicit ROSCvMatContainer(const ROSCvMatContainer & other) {*this = other;}
  ROSCvMatContainer & operator=(const ROSCvMatContainer & other)
  {
    if (this != &other) {
      header_ = other.header_;
      frame_ = other.frame_.clone();
      is_bigendian_ = other.is_bigendian_;
      storage_ = kept(other.storage_);
    }
    return *this;
  }
  explicit ROSCvMatContainer(std::unique_ptr<Image> message)
  : header_(given(message.get()).header), frame_(shown(*message)), storage_(std::move(message)) {}
  explicit ROSCvMatContainer(std::shared_ptr<Image> message)
  : header_(given(message.get()).header), frame_(shown(*message)), storage_(std::move(message)) {}
  explicit ROSCvMatContainer(const Image & message)
  : ROSCvMatContainer(std::make_unique<Image>(message)) {}
  ROSCvMatContainer(const cv::Mat & mat_frame, const Header & header, bool is_bigendian = is_bigendian_system)
  : header_(header), frame_(mat_frame), is_bigendian_(is_bigendian) {}
  ROSCvMatContainer(cv::Mat && mat_frame, const Header & header, bool is_bigendian = is_bigendian_system)
  : header_(header), frame_(std::move(mat_frame)), is_bigendian_(is_bigendian) {}

  /// As Humble answers it: true where no message is kept.
  bool is_owning() const {return std::holds_alternative<std::nullptr_t>(storage_);}
  const cv::Mat & cv_mat() const {return frame_;}
  cv::Mat cv_mat() {return frame_;}
  const Header & header() const {return header_;}
  Header & header() {return header_;}
  bool is_bigendian() const {return is_bigendian_;}
  /// The message that is kept, where it is shared with others; else nullptr.
  std::shared_ptr<const Image> get_sensor_msgs_msg_image_pointer() const
  {
    auto * shared = std::get_if<std::shared_ptr<Image>>(&storage_);
    return shared ? *shared : nullptr;
  }
  std::unique_ptr<Image> get_sensor_msgs_msg_image_pointer_copy() const
  {
    return std::make_unique<Image>(get_sensor_msgs_msg_image_copy());
  }
  Image get_sensor_msgs_msg_image_copy() const
  {
    Image message;
    get_sensor_msgs_msg_image_copy(message);
    return message;
  }
  void get_sensor_msgs_msg_image_copy(Image & message) const
  {
    message.encoding = detail::encoding_of(frame_.type());
    message.header = header_;
    message.height = static_cast<uint32_t>(frame_.rows);
    message.width = static_cast<uint32_t>(frame_.cols);
    message.is_bigendian = is_bigendian_;
    const size_t row = static_cast<size_t>(frame_.cols) * frame_.elemSize();
    message.step = static_cast<uint32_t>(row);
    message.data.resize(row * static_cast<size_t>(frame_.rows));
    for (int y = 0; y < frame_.rows; ++y) {
      std::memcpy(message.data.data() + row * static_cast<size_t>(y), frame_.ptr(y), row);
    }
  }

private:
  static const Image & given(const Image * message)
  {
    if (!message) {
      throw std::invalid_argument("unique_sensor_msgs_image cannot be nullptr");
    }
    return *message;
  }
  static SensorMsgsImageStorageType kept(const SensorMsgsImageStorageType & storage)
  {
    if (auto * shared = std::get_if<std::shared_ptr<Image>>(&storage)) {
      return *shared;
    }
    auto * own = std::get_if<std::unique_ptr<Image>>(&storage);
    return own ? SensorMsgsImageStorageType(std::make_unique<Image>(**own)) : nullptr;
  }
  static cv::Mat shown(Image & message)
  {
    return cv::Mat(
      static_cast<int>(message.height), static_cast<int>(message.width), detail::mat_type_of(message.encoding),
      message.data.data(), message.step);
  }
  Header header_;
  cv::Mat frame_;
  SensorMsgsImageStorageType storage_ = nullptr;
  bool is_bigendian_ = is_bigendian_system;
};
}  // namespace cv_bridge

template<>
struct rclcpp::TypeAdapter<cv_bridge::ROSCvMatContainer, sensor_msgs::msg::Image>
{
  using is_specialized = std::true_type;
  using custom_type = cv_bridge::ROSCvMatContainer;
  using ros_message_type = sensor_msgs::msg::Image;
  static void convert_to_ros_message(const custom_type & source, ros_message_type & destination)
  {
    source.get_sensor_msgs_msg_image_copy(destination);
  }
  static void convert_to_custom(const ros_message_type & source, custom_type & destination)
  {
    destination = custom_type(source);
  }
};
