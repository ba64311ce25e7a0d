# image_tools' headers stand on OpenCV.
find_package(OpenCV REQUIRED)
target_link_libraries(image_tools::image_tools INTERFACE coursekit_opencv)
