// Purpose: validates SPIR-V modules with spirv-val and the rules of Vulkan 1.3. Drivers do not check their
// input, so a malformed module can crash a driver.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace weft::shader {

// Returns the error message of spirv-val, or nullopt if the module is valid.
[[nodiscard]] std::optional<std::string> spirv_fault(const std::vector<uint32_t>& spirv);

}  // namespace weft::shader
