// Purpose: prevents a crash in Mesa's drivers when the disk with their shader cache is full. Mesa 22.3 maps
// the index file of this cache into memory without reserving disk space for it. When Mesa then writes to a
// page for which there is no disk space, the signal SIGBUS ends the process.
#pragma once

namespace weft::viewer {

// Reserves the disk space of the index file of Mesa's shader cache. If this fails, the function prints the
// warning X513 to stderr and disables the cache in this process. The program must call this function before
// it creates a Vulkan instance or threads.
void prepare_driver_cache();

}  // namespace weft::viewer
