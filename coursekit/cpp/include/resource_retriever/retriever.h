#pragma once
#include "resource_retriever/retriever.hpp"
