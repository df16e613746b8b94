// Purpose: the names of the pictures of a sequence, such as seq%04d.png for seq0001.png, seq0002.png and so
// on. Error X524: the name has no place for the number of the frame.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "weft/result.h"

namespace weft::viewer {

// Returns the files for the frames `first` to `last`. `pattern` must contain %d once, or %0Nd for at least N
// digits (1 to 9); %% stands for one %. If `first` is `last`, the pattern may lack the number.
[[nodiscard]] Result<std::vector<std::string>> picture_sequence(const std::string& pattern, uint32_t first,
                                                                uint32_t last);

}  // namespace weft::viewer
