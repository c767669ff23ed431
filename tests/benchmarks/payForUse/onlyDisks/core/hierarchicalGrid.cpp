#include "core/broadphase/hierarchicalGrid.cpp"
