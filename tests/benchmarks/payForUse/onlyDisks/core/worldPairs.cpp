#include "core/world/worldPairs.cpp"
