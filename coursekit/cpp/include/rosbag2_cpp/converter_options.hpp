// Which serialization goes in and out of a bag; there is only "cdr".
#pragma once
#include <string>

namespace rosbag2_cpp
{
struct ConverterOptions
{
  std::string input_serialization_format;
  std::string output_serialization_format;
};
}  // namespace rosbag2_cpp
