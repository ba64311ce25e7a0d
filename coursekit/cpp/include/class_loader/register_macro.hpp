// CLASS_LOADER_REGISTER_CLASS: enter a class under its name when its library is loaded.
#pragma once
#include "class_loader/registry.hpp"

#define CLASS_LOADER_REGISTER_CLASS(Derived, Base) CLASS_LOADER_REGISTER_CLASS_WITH_MESSAGE(Derived, Base, "")
#define CLASS_LOADER_REGISTER_CLASS_WITH_MESSAGE(Derived, Base, Message) \
  COURSEKIT_REGISTER_CLASS(Derived, Base, __COUNTER__)
#define COURSEKIT_REGISTER_CLASS(Derived, Base, n) COURSEKIT_REGISTER_CLASS_(Derived, Base, n)
#define COURSEKIT_REGISTER_CLASS_(Derived, Base, n) \
  namespace {[[maybe_unused]] const bool coursekit_entered_ ## n = \
    class_loader::registry::enter_class<Derived, Base>(#Derived);}
