include("${COURSEKIT_CMAKE}/rosidl_cmake.cmake")
