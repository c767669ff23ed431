#include "core/base/periodicCell.cpp"
