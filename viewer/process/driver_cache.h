// Purpose: prevents a crash when the disk with the shader cache of Mesa's drivers is full. Mesa 22.3 maps a
// file of the cache, the index, without reserving its disk space. The first access to a page without disk
// space ends the process (SIGBUS).
#pragma once

namespace weft::viewer {

// Call this before a Vulkan instance and threads exist. It reserves the disk space of the index. If that
// fails, it prints a warning (X513) on stderr and disables Mesa's cache in this process.
void prepare_driver_cache();

}  // namespace weft::viewer
