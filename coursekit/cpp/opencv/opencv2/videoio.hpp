// Cameras and films.
#pragma once
#include <filesystem>

#include "opencv2/core.hpp"

#include "coursekit/opencv/camera.hpp"

namespace cv
{
/// Writes a film, picture by picture; all pictures have the size that it was opened with.
class VideoWriter : public remote::Device
{
public:
  VideoWriter() = default;
  VideoWriter(const std::string & path, int fourcc, double fps, Size size, bool colour = true)
  {
    open(path, fourcc, fps, size, colour);
  }
  VideoWriter(const std::string & path, int backend, int fourcc, double fps, const Size & size, bool colour = true)
  {
    open(path, backend, fourcc, fps, size, colour);
  }
  ~VideoWriter() override {VideoWriter::release();}
  /// A codec's number of its four letters.
  static int fourcc(char a, char b, char c, char d)
  {
    return (a & 255) | (b & 255) << 8 | (c & 255) << 16 | (d & 255) << 24;
  }
  virtual bool open(const std::string & path, int fourcc, double fps, Size size, bool colour = true)
  {
    return open(path, CAP_ANY, fourcc, fps, size, colour);
  }
  virtual bool open(const std::string & path, int backend, int fourcc, double fps, const Size & size, bool colour = true)
  {
    release();
    std::string whole = std::filesystem::absolute(path).string();  // the session writes it, and works in another folder
    object_ = std::make_shared<remote::Object>("VideoWriter", whole, backend, fourcc, fps, size, colour);
    return isOpened();
  }
  /// End the film: only then its file is whole.
  virtual void release()
  {
    if (object_) {
      object_->call("release");
      object_.reset();
    }
  }
  virtual void write(InputArray image)
  {
    if (object_) {
      object_->call("write", image);
    }
  }
  virtual VideoWriter & operator<<(const Mat & image)
  {
    write(image);
    return *this;
  }
};
}  // namespace cv
