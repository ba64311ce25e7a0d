// A robot that is read from a text or a file, such as the parameter robot_description.
#pragma once
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "urdf_parser/urdf_parser.h"

namespace urdf
{
class Model : public ModelInterface
{
public:
  /// Each says whether there is a robot; what is wrong is said on standard error.
  bool initString(const std::string & text)
  {
    ModelInterfaceSharedPtr read = parseURDF(text);
    if (!read) {
      std::fprintf(stderr, "Failed to parse robot description using: urdf_xml_parser/URDFXMLParser\n");
      return false;
    }
    static_cast<ModelInterface &>(*this) = *read;
    return true;
  }
  bool initFile(const std::string & filename)
  {
    std::ifstream file(filename);
    if (!file) {
      std::fprintf(stderr, "Could not open file [%s] for parsing.\n", filename.c_str());
      return false;
    }
    return initString({std::istreambuf_iterator<char>(file), {}});
  }
};
using ModelSharedPtr = std::shared_ptr<Model>;
using ModelConstSharedPtr = std::shared_ptr<const Model>;
using ModelWeakPtr = std::weak_ptr<Model>;
using ModelUniquePtr = std::unique_ptr<Model>;
}  // namespace urdf
