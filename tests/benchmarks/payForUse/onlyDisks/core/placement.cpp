#include "core/world/placement.cpp"
