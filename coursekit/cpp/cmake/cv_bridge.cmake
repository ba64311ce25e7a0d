# cv_bridge stands on OpenCV.
find_package(OpenCV REQUIRED)
target_link_libraries(cv_bridge::cv_bridge INTERFACE coursekit_opencv)
