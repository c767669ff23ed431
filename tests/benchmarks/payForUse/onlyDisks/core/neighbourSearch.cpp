#include "core/broadphase/neighbourSearch.cpp"
