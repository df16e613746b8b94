// Purpose: the gate that every module passes before it leaves: spirv-val with Vulkan 1.3's rules. Drivers
// trust their input, and a malformed module can crash them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace weft::shader {

// What is wrong with the module, or nothing.
[[nodiscard]] std::optional<std::string> spirv_fault(const std::vector<uint32_t>& spirv);

}  // namespace weft::shader
