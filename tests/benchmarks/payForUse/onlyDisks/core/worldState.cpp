#include "core/world/worldState.cpp"
