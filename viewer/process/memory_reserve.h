// Purpose: reserves memory for reporting that memory is exhausted.
#pragma once

namespace weft::viewer {

// Call this once, first in main(). The first failed allocation frees the reserved 16 MiB and throws
// std::bad_alloc. Without the reserve the error could not be reported: destroying a JSON value allocates
// memory, and an exception in a destructor ends the program.
void hold_memory_reserve();

}  // namespace weft::viewer
