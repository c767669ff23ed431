#include "core/world/contactList.cpp"
