#include "core/world/flatContact.cpp"
