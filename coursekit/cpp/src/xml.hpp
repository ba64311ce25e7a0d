// Reads XML: elements with their attributes. The text between them is passed over.
#pragma once
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace coursekit::xml
{
struct Element
{
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;  // in the order of the file
  std::vector<Element> children;
  int line = 0;

  /// nullptr where there is none of that name.
  const std::string * attribute(const std::string & key) const;
};

/// Tells what is wrong, and in which line.
class Error : public std::runtime_error {using std::runtime_error::runtime_error;};

/// Read a document: its one element at the top.
Element read(const std::string & text);
/// A text as it stands in an attribute, or between elements.
std::string escaped(const std::string & text);
}  // namespace coursekit::xml
