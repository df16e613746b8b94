// Purpose: counts the memory allocations of a thread. The source replaces operator new for its whole program.
#pragma once

#include <cstdint>

namespace weft::test {

// Returns how often the calling thread has called operator new.
[[nodiscard]] uint64_t allocations_of_thread();

}  // namespace weft::test
