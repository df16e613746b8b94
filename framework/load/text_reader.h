// Purpose: the reader of a LoadSettings. Settings without a reader read from disk.
#pragma once

#include "weft/load/load_graph.h"

namespace weft {

[[nodiscard]] FileReader reader_of(const LoadSettings& settings);
// Returns true if the reader returns the contents of files on disk.
[[nodiscard]] bool reads_disk(const LoadSettings& settings);

}  // namespace weft
