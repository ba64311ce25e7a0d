#pragma once
#include "rcutils/logging.h"
