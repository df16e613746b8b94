// Purpose: keeps memory in reserve, so that the program can still report an error after memory has run out.
#pragma once

namespace weft::viewer {

// Allocates the reserve: 64 MiB, or 16 MiB if 64 MiB cannot be allocated. main() must call this function
// once, before anything else. The first failed allocation frees the reserve and throws std::bad_alloc.
// Without the reserve, most errors could not be reported: destroying a JSON value allocates memory, and an
// exception in a destructor ends the program. If the reserve is too small, the program still ends with the
// error X571 and exit code 1.
void hold_memory_reserve();

}  // namespace weft::viewer
