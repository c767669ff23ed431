#include "core/world/worldForces.cpp"
