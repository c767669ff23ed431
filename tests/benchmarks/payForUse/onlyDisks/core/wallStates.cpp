#include "core/world/wallStates.cpp"
