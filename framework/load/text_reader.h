// Purpose: finds the function with which the files of a LoadSettings are read. Without LoadSettings::reader,
// files are read from disk.
#pragma once

#include "weft/load/load_graph.h"

namespace weft {

[[nodiscard]] FileReader reader_of(const LoadSettings& settings);
// Returns true if the reader returns the contents of files on disk.
[[nodiscard]] bool reads_disk(const LoadSettings& settings);

}  // namespace weft
