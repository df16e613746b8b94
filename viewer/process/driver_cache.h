// Purpose: keeps a full disk under the shader cache of Mesa's drivers from ending the program. Mesa 22.3 maps
// a file of the cache, the index, without asking for its disk space: the first access to a page that the disk
// has no room for ends the process (SIGBUS).
#pragma once

namespace weft::viewer {

// Call it before a Vulkan instance is made and before there are threads. Takes the disk space of the index
// now. Where that cannot be had, a warning (X513) goes to stderr, and Mesa runs without its cache in this
// process.
void prepare_driver_cache();

}  // namespace weft::viewer
