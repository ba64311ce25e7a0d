// The descriptions of plugins: the session finds and reads them.
#include "pluginlib/descriptions.hpp"

#include "coursekit/link.hpp"
#include "pluginlib/exceptions.hpp"

namespace pluginlib
{
std::vector<Description> read_descriptions(
  const std::string & package, const std::string & base_class, const std::string & attribute,
  const std::vector<std::string> & paths)
{
  coursekit::Packer with = coursekit::Packer{}.s(package).s(base_class).s(attribute).i(static_cast<int64_t>(paths.size()));
  for (auto & path : paths) {
    with.s(path);
  }
  try {
    coursekit::Unpacker answer = coursekit::request("plugins", with);
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
