// Marks of what a library shows to others: here everything is visible.
#pragma once

#define CONTROLLER_INTERFACE_EXPORT
#define CONTROLLER_INTERFACE_IMPORT
#define CONTROLLER_INTERFACE_PUBLIC
#define CONTROLLER_INTERFACE_PUBLIC_TYPE
#define CONTROLLER_INTERFACE_LOCAL
