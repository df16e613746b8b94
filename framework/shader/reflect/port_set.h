// Purpose: the number of the descriptor set that contains the ports of a pass (its inputs and outputs).
#pragma once

#include <cstdint>

namespace weft::shader {

inline constexpr uint32_t kPortSet = 1;

}  // namespace weft::shader
