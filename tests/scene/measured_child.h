// Purpose: measures the cost of a function. The function runs in a child process, whose CPU time and peak
// resident memory do not depend on the load of the machine.
#pragma once

#include <cstdint>
#include <functional>

namespace weft::test {

struct Cost {
    bool finished = false;  // True if the function returned; false if a signal or an exception ended it.
    int answer = -1;        // Return value of the function, 0 to 200. Valid only if `finished`.
    double cpu_s = 0;       // User and system time of all threads of the child process, in seconds.
    // Peak resident memory of the child process minus its initial resident memory, in bytes.
    uint64_t grown_bytes = 0;
};

[[nodiscard]] Cost cost_of(const std::function<int()>& work);

}  // namespace weft::test
