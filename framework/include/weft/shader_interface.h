// Purpose: describes the inputs and outputs of a compiled shader as data without Vulkan types. weft_shader
// makes this description; weft_graph matches ports with it by name; weft_vulkan makes layouts and pipelines
// from it. Units: offsets and sizes in bytes. Descriptor sets: 0 frame and view, 1 the ports of the pass, 2
// material, 3 draw.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "weft/format.h"

namespace weft {

inline constexpr uint32_t kPortSet = 1;  // Number of the descriptor set that has the ports of a pass.

enum class ShaderStage : uint8_t { vertex, fragment, compute };

using ShaderStageMask = uint32_t;  // A set of shader stages: stage s has the bit 1 << s.
[[nodiscard]] constexpr ShaderStageMask stage_bit(ShaderStage stage) {
    return 1u << static_cast<uint32_t>(stage);
}

enum class ScalarType : uint8_t { f32, i32, u32, boolean };

struct BlockMember {
    std::string name;
    uint32_t offset_bytes = 0;
    uint32_t size_bytes = 0;
    ScalarType scalar = ScalarType::f32;
    uint8_t rows = 1;     // Number of components of a vector, or number of rows of a matrix.
    uint8_t columns = 1;  // Number of columns of a matrix; 1 for scalars and vectors.
    // Number of elements of an array; 0: not an array, or a runtime array (see is_runtime_array).
    uint32_t array_count = 0;
    uint32_t array_stride_bytes = 0;
    bool is_runtime_array = false;
    std::string struct_name;  // Type name of the struct, if the member has a struct type; else empty.
    std::vector<BlockMember> members;  // Members of the struct, if this member has a struct type; else empty.
    bool operator==(const BlockMember&) const = default;
};

enum class BindingKind : uint8_t { sampled_image, storage_image, uniform_buffer, storage_buffer };
enum class ImageDim : uint8_t { d1, d2, d3, cube };

struct ShaderBinding {
    // Instance name in the shader. For a block without an instance name, the name of the block.
    std::string name;
    uint32_t set = 0;
    uint32_t binding = 0;
    BindingKind kind = BindingKind::sampled_image;
    ShaderStageMask stages = 0;
    uint32_t count = 1;  // Number of descriptors of an array; 1 for a single descriptor.
    bool is_array = false;
    // The members from `dim` to storage_format describe images.
    ImageDim dim = ImageDim::d2;
    bool arrayed = false;
    bool multisampled = false;
    bool shadow = false;  // True for samplers that compare, such as sampler2DShadow.
    // False for a sampled image from which the shader reads only single texels, with texelFetch().
    bool filters = true;
    NumericClass numeric = NumericClass::float_like;
    // Format qualifier of a storage image in GLSL; undefined if the shader gives none.
    Format storage_format = Format::undefined;
    // The members `reads` and `writes` describe how the shader accesses a storage image or buffer.
    bool reads = true;
    bool writes = false;
    // The members block_bytes and `members` describe buffers.
    uint32_t block_bytes = 0;  // Size of the block, without the elements of a runtime array at its end.
    std::vector<BlockMember> members;
    // True: the shader declares the array without a size. The size is that of the table of textures. `count`
    // is then 1.
    bool is_runtime_array = false;
    bool operator==(const ShaderBinding&) const = default;
};

// The shader's block with the name `Params`. It is either push constants or a uniform buffer in set 1.
struct ParamsBlock {
    bool push_constants = false;
    uint32_t binding = 0;  // Binding number, if the block is a uniform buffer.
    uint32_t size_bytes = 0;
    ShaderStageMask stages = 0;
    std::vector<BlockMember> members;
    bool operator==(const ParamsBlock&) const = default;
};

struct SpecConstant {
    std::string name;
    uint32_t id = 0;
    ScalarType type = ScalarType::boolean;
    uint32_t default_bits = 0;
};

struct StageVariable {
    std::string name;
    uint32_t location = 0;
    ScalarType scalar = ScalarType::f32;
    uint8_t components = 4;
};

// A part of a uniform block in descriptor set 0, which has the constants of the frame and of the view.
struct FrameRange {
    uint32_t binding = 0;
    uint32_t offset_bytes = 0;
    uint32_t size_bytes = 0;
    bool operator==(const FrameRange&) const = default;
};

struct ShaderInterface {
    ShaderStageMask stages = 0;
    std::vector<ShaderBinding> bindings;  // Descriptors that the shader uses, sorted by set, then by binding.
    // The parts of the uniform blocks in set 0 that the shader can read, sorted by binding and offset. They
    // do not overlap.
    std::vector<FrameRange> frame_ranges;
    bool has_params = false;
    ParamsBlock params;
    std::vector<SpecConstant> spec_constants;  // Specialisation constants, sorted by name.
    std::vector<StageVariable> vertex_inputs;  // Inputs of the vertex stage, sorted by location.
    std::vector<StageVariable> fragment_outputs;
    std::array<uint32_t, 3> local_size{1, 1, 1};
    bool discards = false;           // True: the fragment stage can discard its fragment.
    bool writes_depth = false;       // True: the fragment stage writes gl_FragDepth.
    bool writes_point_size = false;  // True: the vertex stage writes gl_PointSize.
    // True: the SPIR-V needs a device with tables of textures (DeviceProfile::texture_table), because it has
    // an array without a size, or an index that differs between invocations.
    bool needs_texture_tables = false;
    // False for a compute stage without `layout(local_size_x = ...) in`; true for all others.
    bool states_local_size = true;

    // Finds a binding by name in set 1, which has the ports of the pass. Returns null if there is none.
    [[nodiscard]] const ShaderBinding* find(std::string_view name) const;
};

struct ShaderModule {
    ShaderStage stage = ShaderStage::compute;
    std::vector<uint32_t> spirv;  // SPIR-V code that spirv-val has accepted. The entry point is "main".
};

// The compiled program for the name of a shader in a graph: a compute stage, or a vertex and a fragment
// stage.
struct ShaderProgram {
    std::string reference;  // The name of the shader, as in the graph.
    std::vector<ShaderModule> modules;
    ShaderInterface interface;
    // Hash of the shader's name, the compiler's version, and all GLSL texts, including the included files.
    uint64_t content_hash = 0;
};

// The compiled programs by the shader's name in the graph. A shader with errors has an entry without modules.
// Its errors were already reported, so later stages report no further error for it.
using ShaderCatalog = std::map<std::string, ShaderProgram, std::less<>>;

}  // namespace weft
