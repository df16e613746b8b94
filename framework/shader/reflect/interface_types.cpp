#include "shader/reflect/interface_types.h"

#include <array>
#include <utility>

namespace weft::shader {

namespace {

constexpr std::array kScalars = {
    std::pair{SPVC_BASETYPE_FP32, ScalarType::f32},
    std::pair{SPVC_BASETYPE_INT32, ScalarType::i32},
    std::pair{SPVC_BASETYPE_UINT32, ScalarType::u32},
    std::pair{SPVC_BASETYPE_BOOLEAN, ScalarType::boolean},
};

constexpr std::array kDims = {
    std::pair{SpvDim1D, ImageDim::d1},
    std::pair{SpvDim2D, ImageDim::d2},
    std::pair{SpvDim3D, ImageDim::d3},
    std::pair{SpvDimCube, ImageDim::cube},
};

constexpr std::array kFormats = {
    std::pair{SpvImageFormatRgba32f, Format::rgba32f},
    std::pair{SpvImageFormatRgba16f, Format::rgba16f},
    std::pair{SpvImageFormatR32f, Format::r32f},
    std::pair{SpvImageFormatRgba8, Format::rgba8},
    std::pair{SpvImageFormatRgba8Snorm, Format::rgba8_snorm},
    std::pair{SpvImageFormatRg32f, Format::rg32f},
    std::pair{SpvImageFormatRg16f, Format::rg16f},
    std::pair{SpvImageFormatR11fG11fB10f, Format::b10g11r11f},
    std::pair{SpvImageFormatR16f, Format::r16f},
    std::pair{SpvImageFormatRgba16, Format::rgba16},
    std::pair{SpvImageFormatRgb10A2, Format::rgb10a2},
    std::pair{SpvImageFormatRg16, Format::rg16},
    std::pair{SpvImageFormatRg8, Format::rg8},
    std::pair{SpvImageFormatR16, Format::r16},
    std::pair{SpvImageFormatR8, Format::r8},
    std::pair{SpvImageFormatRgba16Snorm, Format::rgba16_snorm},
    std::pair{SpvImageFormatRg16Snorm, Format::rg16_snorm},
    std::pair{SpvImageFormatRg8Snorm, Format::rg8_snorm},
    std::pair{SpvImageFormatR8Snorm, Format::r8_snorm},
    std::pair{SpvImageFormatRgba32i, Format::rgba32i},
    std::pair{SpvImageFormatRg32i, Format::rg32i},
    std::pair{SpvImageFormatR32i, Format::r32i},
    std::pair{SpvImageFormatRgba32ui, Format::rgba32u},
    std::pair{SpvImageFormatRgba16ui, Format::rgba16u},
    std::pair{SpvImageFormatRgba8ui, Format::rgba8u},
    std::pair{SpvImageFormatR32ui, Format::r32u},
    std::pair{SpvImageFormatRg32ui, Format::rg32u},
    std::pair{SpvImageFormatRg16ui, Format::rg16u},
    std::pair{SpvImageFormatRg8ui, Format::rg8u},
    std::pair{SpvImageFormatR16ui, Format::r16u},
    std::pair{SpvImageFormatR8ui, Format::r8u},
};

// Returns the value of this library for a value of SPIR-V, if the table has it.
template <class Theirs, class Ours, size_t N>
std::optional<Ours> ours_for(Theirs value, const std::array<std::pair<Theirs, Ours>, N>& table) {
    for (const auto& [spirv, ours] : table)
        if (spirv == value) return ours;
    return std::nullopt;
}

}  // namespace

std::optional<ScalarType> to_scalar(spvc_basetype type) {
    return ours_for(type, kScalars);
}

std::optional<ImageDim> to_dim(SpvDim dim) {
    return ours_for(dim, kDims);
}

Format to_format(SpvImageFormat format) {
    return ours_for(format, kFormats).value_or(Format::undefined);
}

uint32_t array_count(spvc_compiler compiler, spvc_type type, bool& is_runtime) {
    is_runtime = false;
    const unsigned dimensions = spvc_type_get_num_array_dimensions(type);
    uint32_t count = dimensions == 0 ? 0 : 1;
    for (unsigned i = 0; i < dimensions; ++i) {
        uint32_t extent = spvc_type_get_array_dimension(type, i);
        if (spvc_type_array_dimension_is_literal(type, i) == SPVC_FALSE) {
            extent = spvc_constant_get_scalar_u32(spvc_compiler_get_constant_handle(compiler, extent), 0, 0);
        }
        if (extent == 0) {
            is_runtime = true;
        } else {
            count *= extent;
        }
    }
    return count;
}

namespace {

// Returns the distance in bytes from one array element to the next. For an array of arrays, SPIRV-Cross
// returns the stride of the outermost dimension. element_stride() divides this stride by the lengths of the
// inner dimensions.
uint32_t element_stride(spvc_compiler compiler, spvc_type block, spvc_type type, unsigned index) {
    const unsigned dimensions = spvc_type_get_num_array_dimensions(type);
    unsigned stride = 0;
    if (dimensions == 0) return 0;
    spvc_compiler_type_struct_member_array_stride(compiler, block, index, &stride);
    for (unsigned i = 0; i + 1 < dimensions; ++i) {
        const unsigned inner = spvc_type_get_array_dimension(type, i);
        if (inner > 0) stride /= inner;
    }
    return stride;
}

BlockMember block_member(spvc_compiler compiler, spvc_type_id block_id, unsigned index,
                         std::vector<std::string>& foreign) {
    const spvc_type block = spvc_compiler_get_type_handle(compiler, block_id);
    const spvc_type_id type_id = spvc_type_get_member_type(block, index);
    const spvc_type type = spvc_compiler_get_type_handle(compiler, type_id);

    BlockMember member;
    member.name = spvc_compiler_get_member_name(compiler, block_id, index);
    unsigned offset = 0;
    spvc_compiler_type_struct_member_offset(compiler, block, index, &offset);
    member.offset_bytes = offset;
    member.rows = static_cast<uint8_t>(spvc_type_get_vector_size(type));
    member.columns = static_cast<uint8_t>(spvc_type_get_columns(type));
    const uint32_t count = array_count(compiler, type, member.is_runtime_array);
    member.array_count = member.is_runtime_array ? 0 : count;
    member.array_stride_bytes = element_stride(compiler, block, type, index);
    if (!member.is_runtime_array) {
        size_t size = 0;
        spvc_compiler_get_declared_struct_member_size(compiler, block, index, &size);
        member.size_bytes = static_cast<uint32_t>(size);
    }

    const spvc_basetype base = spvc_type_get_basetype(type);
    if (base == SPVC_BASETYPE_STRUCT &&
        spvc_type_get_storage_class(type) != SpvStorageClassPhysicalStorageBuffer) {
        const spvc_type_id inner = spvc_type_get_base_type_id(type);
        member.struct_name = spvc_compiler_get_name(compiler, inner);
        member.members = block_members(compiler, inner, foreign);
    } else if (const auto scalar = to_scalar(base)) {
        member.scalar = *scalar;
    } else {
        foreign.push_back(std::string(spvc_compiler_get_name(compiler, block_id)) + "." + member.name);
    }
    return member;
}

}  // namespace

std::vector<BlockMember> block_members(spvc_compiler compiler, spvc_type_id block,
                                       std::vector<std::string>& foreign) {
    std::vector<BlockMember> members;
    const unsigned count = spvc_type_get_num_member_types(spvc_compiler_get_type_handle(compiler, block));
    for (unsigned i = 0; i < count; ++i) members.push_back(block_member(compiler, block, i, foreign));
    return members;
}

}  // namespace weft::shader
