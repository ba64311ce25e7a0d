// Robots from their descriptions in XML; the session reads them.
#pragma once
#include <string>

#include "urdf_model/model.h"

namespace urdf
{
/// The robot that a text describes, or null where it describes none; what is wrong with it is said on standard error.
ModelInterfaceSharedPtr parseURDF(const std::string & text);
ModelInterfaceSharedPtr parseURDFFile(const std::string & path);
}  // namespace urdf
