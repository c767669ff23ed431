#include "core/broadphase/neighbourList.cpp"
