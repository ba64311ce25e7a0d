# OpenCV: the system's where it has one for C++, else the headers here, whose functions Python's cv2 answers. Cameras and
# windows are the session's in both.
#   COURSEKIT_OPENCV   `face` takes the headers here even where the system has OpenCV

if(NOT TARGET coursekit_opencv)
  _add_library(coursekit_opencv INTERFACE IMPORTED GLOBAL)
  file(GLOB _coursekit_found
    "/usr/lib/cmake/opencv4/OpenCVConfig.cmake" "/usr/lib/*/cmake/opencv4/OpenCVConfig.cmake"
    "/usr/local/lib/cmake/opencv4/OpenCVConfig.cmake" "/opt/homebrew/lib/cmake/opencv4/OpenCVConfig.cmake")
  if(_coursekit_found AND NOT COURSEKIT_OPENCV STREQUAL "face")
    list(GET _coursekit_found 0 _coursekit_found)
    include("${_coursekit_found}")
    list(PREPEND OpenCV_INCLUDE_DIRS "${COURSEKIT_ROOT}/opencv_system")
    foreach(_coursekit_part IN LISTS OpenCV_LIBS) # for those who link to one part only
      set_property(TARGET ${_coursekit_part} PROPERTY INTERFACE_INCLUDE_DIRECTORIES ${OpenCV_INCLUDE_DIRS})
      set_property(TARGET ${_coursekit_part} APPEND PROPERTY INTERFACE_LINK_LIBRARIES coursekit_headers)
    endforeach()
    target_include_directories(coursekit_opencv SYSTEM INTERFACE ${OpenCV_INCLUDE_DIRS})
    target_link_libraries(coursekit_opencv INTERFACE coursekit_headers ${OpenCV_LIBS})
  else()
    target_include_directories(coursekit_opencv SYSTEM INTERFACE "${COURSEKIT_ROOT}/opencv")
    target_link_libraries(coursekit_opencv INTERFACE coursekit_headers)
  endif()
endif()

get_target_property(OpenCV_INCLUDE_DIRS coursekit_opencv INTERFACE_INCLUDE_DIRECTORIES)
set(OpenCV_FOUND TRUE)
set(OpenCV_LIBS coursekit_opencv)
set(OpenCV_LIBRARIES coursekit_opencv)
set(OpenCV_TARGETS coursekit_opencv)
foreach(_coursekit_part core imgproc imgcodecs videoio highgui calib3d objdetect video features2d aruco)
  if(NOT TARGET opencv_${_coursekit_part})
    _add_library(opencv_${_coursekit_part} INTERFACE IMPORTED GLOBAL)
    target_link_libraries(opencv_${_coursekit_part} INTERFACE coursekit_opencv)
  endif()
endforeach()
