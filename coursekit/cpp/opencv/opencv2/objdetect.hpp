// Things that are found by what they look like: faces by trained cascades, QR codes.
#pragma once
#include "opencv2/core.hpp"
#include "opencv2/imgproc.hpp"

namespace cv
{
enum {CASCADE_DO_CANNY_PRUNING = 1, CASCADE_SCALE_IMAGE = 2, CASCADE_FIND_BIGGEST_OBJECT = 4, CASCADE_DO_ROUGH_SEARCH = 8};

class CascadeClassifier
{
public:
  CascadeClassifier() = default;
  explicit CascadeClassifier(const std::string & file) {load(file);}
  /// Read what was trained; those that come with OpenCV are found in any folder.
  bool load(const std::string & file)
  {
    object_ = std::make_shared<remote::Object>("cascade", file);
    return !empty();
  }
  bool empty() const {return !object_ || object_->call("empty").integer != 0;}
  void detectMultiScale(
    InputArray image, std::vector<Rect> & found, double scale = 1.1, int neighbours = 3, int flags = 0,
    Size smallest = Size(), Size largest = Size())
  {
    detail::fill(
      found, object_->call("detectMultiScale", image, scale, neighbours, flags, smallest, largest));
  }

private:
  std::shared_ptr<remote::Object> object_;
};

/// Finds what a trained vector tells from everything else: people, with the one that comes with OpenCV.
class HOGDescriptor
{
public:
  HOGDescriptor()
  : object_(std::make_shared<remote::Object>("HOGDescriptor")) {}
  static std::vector<float> getDefaultPeopleDetector()
  {
    std::vector<float> trained;
    detail::fill(trained, remote::call("HOGDescriptor_getDefaultPeopleDetector"));
    return trained;
  }
  void setSVMDetector(InputArray trained) {object_->call("setSVMDetector", trained);}
  void detectMultiScale(
    InputArray image, std::vector<Rect> & found, std::vector<double> & weights, double threshold = 0, Size stride = Size(),
    Size padding = Size(), double scale = 1.05, double together = 2, bool meanshift = false) const
  {
    auto answer = object_->call("detectMultiScale", image, threshold, stride, padding, scale, together, meanshift);
    detail::fill(found, answer[0]);
    detail::fill(weights, answer[1]);
  }
  void detectMultiScale(
    InputArray image, std::vector<Rect> & found, double threshold = 0, Size stride = Size(), Size padding = Size(),
    double scale = 1.05, double together = 2, bool meanshift = false) const
  {
    std::vector<double> weights;
    detectMultiScale(image, found, weights, threshold, stride, padding, scale, together, meanshift);
  }

private:
  std::shared_ptr<remote::Object> object_;
};

class QRCodeDetector
{
public:
  QRCodeDetector()
  : object_(std::make_shared<remote::Object>("QRCodeDetector")) {}
  bool detect(InputArray image, OutputArray points) const
  {
    auto found = object_->call("detect", image);
    points.assign(found[1]);
    return found[0].integer != 0;
  }
  std::string decode(InputArray image, InputArray points, OutputArray straight = noArray())
  {
    auto read = object_->call("decode", image, points);
    straight.assign(read[1]);
    return read[0].text;
  }
  std::string detectAndDecode(InputArray image, OutputArray points = noArray(), OutputArray straight = noArray())
  {
    auto read = object_->call("detectAndDecode", image);
    points.assign(read[1]);
    straight.assign(read[2]);
    return read[0].text;
  }

private:
  std::shared_ptr<remote::Object> object_;
};
}  // namespace cv
