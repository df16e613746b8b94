// Purpose: converts types of SPIRV-Cross to Weft's types: block members, scalar types, image dimensions and
// formats. Only the source files of the reflection include this header, because it depends on SPIRV-Cross.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "spirv_cross_c.h"
#include "weft/shader_interface.h"

namespace weft::shader {

// Returns the scalar type, or nullopt for every type that is neither a 32-bit number nor bool. Examples:
// structs, 16-bit and 64-bit numbers, pointers, opaque types.
[[nodiscard]] std::optional<ScalarType> to_scalar(spvc_basetype type);
[[nodiscard]] std::optional<ImageDim> to_dim(SpvDim dim);
// Returns the format of a storage image. Returns `undefined` if the shader declares no format, or a format
// that Weft does not support.
[[nodiscard]] Format to_format(SpvImageFormat format);

// Returns the members of a block or struct. The names of members with unsupported types are added to
// `foreign`, in the form "block.member" or "struct.member".
[[nodiscard]] std::vector<BlockMember> block_members(spvc_compiler compiler, spvc_type_id block,
                                                     std::vector<std::string>& foreign);

// Returns the product of all dimensions of an array type, or 0 if the type is not an array. A dimension
// without a size counts as 1 and sets `is_runtime` to true.
[[nodiscard]] uint32_t array_count(spvc_compiler compiler, spvc_type type, bool& is_runtime);

}  // namespace weft::shader
