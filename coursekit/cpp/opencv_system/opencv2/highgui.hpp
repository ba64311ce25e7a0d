// The system's OpenCV with the session's windows: a notebook shows them, and they wait on its clock, as in Python.
#pragma once
#include "opencv2/videoio.hpp"

#include_next <opencv2/highgui.hpp>

#include "coursekit/opencv/windows.hpp"
