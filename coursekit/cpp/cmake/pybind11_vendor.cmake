# pybind11 is the system's, or a wheel.
include("${COURSEKIT_CMAKE}/vendor.cmake")
_coursekit_vendor(pybind11 pybind11-dev)
