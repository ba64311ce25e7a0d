#pragma once
#include "tf2/convert.h"
