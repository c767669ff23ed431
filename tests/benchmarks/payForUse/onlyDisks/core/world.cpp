#include "core/world/world.cpp"
