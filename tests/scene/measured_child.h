// Purpose: measures the cost of a function: runs it in a child process and reads the child's CPU time and
// peak resident memory, which do not depend on the load of the machine. Names contain the units.
#pragma once

#include <cstdint>
#include <functional>

namespace weft::test {

struct Cost {
    bool finished = false;     // false: ended by a signal or an exception
    int answer = -1;           // return value of the function, 0 to 200
    double cpu_s = 0;          // user and system time of all its threads
    uint64_t grown_bytes = 0;  // peak resident memory minus the initial resident memory
};

[[nodiscard]] Cost cost_of(const std::function<int()>& work);

}  // namespace weft::test
