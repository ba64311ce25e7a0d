// The descriptions of plugins: the session finds and reads them.
#include "pluginlib/descriptions.hpp"

#include "coursekit/link.hpp"
#include "pluginlib/exceptions.hpp"

namespace pluginlib
{
std::vector<Description> read_descriptions(const std::string & package, const std::string & base_class)
{
  try {
    coursekit::Unpacker answer = coursekit::request("plugins", coursekit::Packer{}.s(package).s(base_class));
    std::vector<Description> all(static_cast<size_t>(answer.i()));
    for (auto & one : all) {
      for (auto field : {&one.name, &one.type, &one.library, &one.description, &one.package, &one.manifest}) {
        *field = answer.s();
      }
      one.has_library = answer.i();
    }
    return all;
  } catch (const coursekit::Refused & refusal) {
    if (refusal.kind == "InvalidManifest") {
      throw InvalidXMLException(refusal.what());
    }
    throw ClassLoaderException(refusal.what());
  }
}
}  // namespace pluginlib
