// Purpose: reserves memory for reporting that memory is exhausted.
#pragma once

namespace weft::viewer {

// Call this once, first in main(). The first failed allocation frees the reserved 64 MiB and throws
// std::bad_alloc. Without the reserve most errors could not be reported: destroying a JSON value allocates
// memory, and an exception in a destructor ends the program. Where the reserve does not suffice, the program
// still ends with X571 and exit code 1.
void hold_memory_reserve();

}  // namespace weft::viewer
