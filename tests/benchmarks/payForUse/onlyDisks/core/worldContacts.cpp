#include "core/world/worldContacts.cpp"
