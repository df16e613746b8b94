// Purpose: validates every module with spirv-val and the rules of Vulkan 1.3. Drivers do not check their
// input, so a malformed module can crash them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace weft::shader {

// The text of spirv-val's error; nullopt for a valid module.
[[nodiscard]] std::optional<std::string> spirv_fault(const std::vector<uint32_t>& spirv);

}  // namespace weft::shader
