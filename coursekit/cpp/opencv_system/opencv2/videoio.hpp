// The system's OpenCV with the session's camera: number 0 is the virtual one where the computer has none, as in Python.
#pragma once
#define VideoCapture VideoCaptureOfTheSystem
#include_next <opencv2/videoio.hpp>
#undef VideoCapture

#include "opencv2/core.hpp"

#include "coursekit/opencv/camera.hpp"
