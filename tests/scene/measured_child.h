// Purpose: what a piece of work costs: it runs in a child process, which is asked for its CPU time and its
// largest resident memory. Neither depends on how busy the machine is. Units are in names.
#pragma once

#include <cstdint>
#include <functional>

namespace weft::test {

struct Cost {
    bool finished = false;     // false: a signal ended it, or an exception left it
    int answer = -1;           // what the work returned, 0 to 200
    double cpu_s = 0;          // user and system, of all its threads
    uint64_t grown_bytes = 0;  // of resident memory, above what the child began with
};

[[nodiscard]] Cost cost_of(const std::function<int()>& work);

}  // namespace weft::test
