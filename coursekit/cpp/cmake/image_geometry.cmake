# image_geometry stands on OpenCV.
find_package(OpenCV REQUIRED)
target_link_libraries(image_geometry::image_geometry INTERFACE coursekit_opencv)
