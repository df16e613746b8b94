// Purpose: the descriptor set that holds the ports of a pass.
#pragma once

#include <cstdint>

namespace weft::shader {

inline constexpr uint32_t kPortSet = 1;

}  // namespace weft::shader
