// Cameras and films: number 0 is the course's virtual camera where the computer has none.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "coursekit/opencv/remote.hpp"

namespace cv
{
namespace remote
{
/// A camera or a film, read or written: an object of cv2's, once it is opened.
class Device
{
public:
  virtual ~Device() = default;
  virtual bool isOpened() const {return object_ && object_->call("isOpened").integer;}
  virtual bool set(int property, double value) {return object_ && object_->call("set", property, value).integer;}
  virtual double get(int property) const {return object_ ? object_->call("get", property).number() : 0;}
  std::string getBackendName() const {return object_ ? object_->call("getBackendName").text : "";}

protected:
  std::shared_ptr<Object> object_;
};
}  // namespace remote

class VideoCapture : public remote::Device
{
public:
  VideoCapture() = default;
  explicit VideoCapture(int index, int backend = CAP_ANY) {open(index, backend);}
  explicit VideoCapture(const std::string & path, int backend = CAP_ANY) {open(path, backend);}
  VideoCapture(int index, int backend, const std::vector<int> & params) {open(index, backend, params);}
  VideoCapture(const std::string & path, int backend, const std::vector<int> & params) {open(path, backend, params);}
  virtual bool open(int index, int = CAP_ANY) {return begin(index);}
  virtual bool open(const std::string & path, int = CAP_ANY)
  {
    return begin(std::filesystem::exists(path) ? std::filesystem::absolute(path).string() : path);  // else an address
  }
  /// `params` are properties, each followed by its value.
  virtual bool open(int index, int backend, const std::vector<int> & params) {return open(index, backend) && set_all(params);}
  virtual bool open(const std::string & path, int backend, const std::vector<int> & params)
  {
    return open(path, backend) && set_all(params);
  }
  virtual void release() {object_.reset();}
  virtual bool grab() {return object_ && object_->call("grab").integer;}
  virtual bool retrieve(OutputArray image, int flag = 0) {return taken(object_, "retrieve", image, remote::kw("flag", flag));}
  virtual bool read(OutputArray image) {return taken(object_, "read", image);}
  virtual VideoCapture & operator>>(Mat & image)
  {
    read(image);
    return *this;
  }

private:
  bool set_all(const std::vector<int> & params)
  {
    for (size_t i = 0; i + 1 < params.size(); i += 2) {
      set(params[i], params[i + 1]);
    }
    return isOpened();
  }
  template<class From>
  bool begin(const From & from)
  {
    object_.reset();  // first: it gives the camera back
    object_ = std::make_shared<remote::Object>("VideoCapture", from);
    return isOpened();
  }
  /// The next picture; where there is none the image is emptied.
  template<class ... A>
  static bool taken(
    const std::shared_ptr<remote::Object> & from, const char * how, OutputArray image, const A & ... arguments)
  {
    remote::Value both;
    if (from) {
      both = from->call(how, arguments ...);
    }
    bool there = both.items.size() == 2 && both[0].integer;
    image.assign(there ? both[1].mat : Mat());
    return there;
  }
};
}  // namespace cv
