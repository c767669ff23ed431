#include "core/world/wallContact.cpp"
