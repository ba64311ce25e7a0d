#pragma once
#include "rcutils/error_handling.h"
