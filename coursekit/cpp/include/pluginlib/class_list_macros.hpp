// PLUGINLIB_EXPORT_CLASS: what a library offers to those that load it by the description of its plugins.
#pragma once
#include "class_loader/register_macro.hpp"

#define PLUGINLIB_EXPORT_CLASS(class_type, base_class_type) CLASS_LOADER_REGISTER_CLASS(class_type, base_class_type)
