#include "core/base/setupError.cpp"
