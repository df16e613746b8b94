// Purpose: converts SPIRV-Cross types to Weft's types: block members, scalar types, image dimensions and
// formats. Only the reflection sources include this header, because it exposes SPIRV-Cross.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "spirv_cross_c.h"
#include "weft/shader_interface.h"

namespace weft::shader {

// nullopt for types that blocks and stage variables of Weft cannot have (16 and 64 bits, pointers, opaque
// types).
[[nodiscard]] std::optional<ScalarType> to_scalar(spvc_basetype type);
[[nodiscard]] std::optional<ImageDim> to_dim(SpvDim dim);
// `undefined` when no format is declared, and for formats that Weft does not support.
[[nodiscard]] Format to_format(SpvImageFormat format);

// Adds the names of members with unsupported types to `foreign`, as "block.member".
[[nodiscard]] std::vector<BlockMember> block_members(spvc_compiler compiler, spvc_type_id block,
                                                     std::vector<std::string>& foreign);

// Product of all dimensions: 0 if the type is not an array; a runtime dimension counts as 1 and sets
// `is_runtime`.
[[nodiscard]] uint32_t array_count(spvc_compiler compiler, spvc_type type, bool& is_runtime);

}  // namespace weft::shader
