// Numbers and truth values from the texts of a description, in whatever language the system speaks.
#pragma once
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>

namespace hardware_interface
{
/// Throws std::invalid_argument for what is no number.
inline double stod(const std::string & s)
{
  std::istringstream stream(s);
  stream.imbue(std::locale::classic());
  double value;
  if (!(stream >> value) || stream.peek() != std::istringstream::traits_type::eof()) {
    throw std::invalid_argument("Failed converting string to real number");
  }
  return value;
}
inline bool parse_bool(const std::string & bool_string) {return bool_string == "true" || bool_string == "True";}
}  // namespace hardware_interface
