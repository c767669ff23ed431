#include "core/world/worldNeighbours.cpp"
