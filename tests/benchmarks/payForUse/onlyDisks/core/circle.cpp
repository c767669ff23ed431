#include "core/shapes/circle.cpp"
