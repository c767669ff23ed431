#include "core/world/worldStep.cpp"
