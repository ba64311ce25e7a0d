#pragma once
#include "opencv2/objdetect.hpp"
