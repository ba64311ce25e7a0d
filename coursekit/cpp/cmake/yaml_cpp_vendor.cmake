# yaml-cpp is the system's.
include("${COURSEKIT_CMAKE}/vendor.cmake")
_coursekit_vendor(yaml-cpp libyaml-cpp-dev)
