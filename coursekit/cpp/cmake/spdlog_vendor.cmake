# spdlog is the system's.
include("${COURSEKIT_CMAKE}/vendor.cmake")
_coursekit_vendor(spdlog libspdlog-dev)
