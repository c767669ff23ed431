#include "core/world/pairContact.cpp"
