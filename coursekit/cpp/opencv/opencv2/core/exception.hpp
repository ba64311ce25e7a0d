// What OpenCV throws.
#pragma once
#include <stdexcept>
#include <string>

#define CV_VERSION_MAJOR 4
#define CV_VERSION_MINOR 5
#define CV_VERSION_REVISION 4
#define CV_MAJOR_VERSION CV_VERSION_MAJOR
#define CV_MINOR_VERSION CV_VERSION_MINOR
#define CV_SUBMINOR_VERSION CV_VERSION_REVISION
#define CV_VERSION "4.5.4"

namespace cv
{
class Exception : public std::exception
{
public:
  Exception() = default;
  Exception(int code_, const std::string & err_, const std::string & func_, const std::string & file_, int line_)
  : err(err_), func(func_), file(file_), code(code_), line(line_)
  {
    msg = "OpenCV(" CV_VERSION ") " + file + ":" + std::to_string(line) + ": error: (" + std::to_string(code) + ") " + err;
    msg += func.empty() ? "\n" : " in function '" + func + "'\n";
  }
  const char * what() const noexcept override {return msg.c_str();}
  std::string msg, err, func, file;
  int code = -2, line = 0;
};
[[noreturn]] inline void error(int code, const std::string & text, const char * func, const char * file, int line)
{
  throw Exception(code, text, func, file, line);
}
}  // namespace cv
#define CV_Assert(condition) \
  do { \
    if (!(condition)) { \
      throw cv::Exception(-215, "Assertion failed: " #condition, __func__, __FILE__, __LINE__); \
    } \
  } while (0)
#define CV_Error(code, text) cv::error(code, text, __func__, __FILE__, __LINE__)
