// Purpose: memory that running out of memory can be reported with.
#pragma once

namespace weft::viewer {

// Call once, first in main(). The first allocation that fails gives 16 MiB back, which were held for this,
// and throws std::bad_alloc. Without them the error could not be reported: a JSON value allocates memory when
// it is destroyed, and an exception there ends the program.
void hold_memory_reserve();

}  // namespace weft::viewer
