/// Serves steps by the core that knows disks only.

#include "benchmarks/payForUse/stepServer.hpp"

int main(int argumentCount, char** arguments)
{
    return chesil::benchmark::mainOfServer(argumentCount, arguments);
}
