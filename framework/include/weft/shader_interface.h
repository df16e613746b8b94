// Purpose: the inputs and outputs of a compiled shader as plain data. weft_shader makes it; weft_graph reads
// it to match ports by name, weft_vulkan to make layouts and pipelines. No Vulkan. Units: offsets and sizes
// in bytes. Sets: 0 frame and view, 1 the pass's ports, 2 material, 3 draw.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "weft/format.h"

namespace weft {

inline constexpr uint32_t kPortSet = 1;  // the descriptor set of a pass's ports

enum class ShaderStage : uint8_t { vertex, fragment, compute };

using ShaderStageMask = uint32_t;  // bit = 1 << ShaderStage
[[nodiscard]] constexpr ShaderStageMask stage_bit(ShaderStage stage) {
    return 1u << static_cast<uint32_t>(stage);
}

enum class ScalarType : uint8_t { f32, i32, u32, boolean };

struct BlockMember {
    std::string name;
    uint32_t offset_bytes = 0;
    uint32_t size_bytes = 0;
    ScalarType scalar = ScalarType::f32;
    uint8_t rows = 1;          // components of a vector, or rows of a matrix
    uint8_t columns = 1;       // > 1 for matrices
    uint32_t array_count = 0;  // 0: not an array; runtime arrays have is_runtime_array
    uint32_t array_stride_bytes = 0;
    bool is_runtime_array = false;
    std::string struct_name;           // set for members of struct type
    std::vector<BlockMember> members;  // members of that struct
    bool operator==(const BlockMember&) const = default;
};

enum class BindingKind : uint8_t { sampled_image, storage_image, uniform_buffer, storage_buffer };
enum class ImageDim : uint8_t { d1, d2, d3, cube };

struct ShaderBinding {
    std::string name;  // instance name; for blocks without one, the block's name
    uint32_t set = 0;
    uint32_t binding = 0;
    BindingKind kind = BindingKind::sampled_image;
    ShaderStageMask stages = 0;
    uint32_t count = 1;  // array size of the descriptor
    // images
    ImageDim dim = ImageDim::d2;
    bool arrayed = false;
    bool multisampled = false;
    bool shadow = false;  // sampler2DShadow and similar types
    NumericClass numeric = NumericClass::float_like;
    Format storage_format = Format::undefined;  // the GLSL format qualifier; undefined if there is none
    // storage images and buffers
    bool reads = true;
    bool writes = false;
    // buffers
    uint32_t block_bytes = 0;  // without the elements of a runtime array
    std::vector<BlockMember> members;
    bool operator==(const ShaderBinding&) const = default;
};

// The block named `Params`: push constants, or a uniform buffer in set 1.
struct ParamsBlock {
    bool push_constants = false;
    uint32_t binding = 0;  // for a uniform buffer
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

struct ShaderInterface {
    ShaderStageMask stages = 0;
    std::vector<ShaderBinding> bindings;  // sorted by set, then binding
    bool has_params = false;
    ParamsBlock params;
    std::vector<SpecConstant> spec_constants;  // sorted by name
    std::vector<StageVariable> vertex_inputs;  // sorted by location
    std::vector<StageVariable> fragment_outputs;
    std::array<uint32_t, 3> local_size{1, 1, 1};
    bool discards = false;           // the fragment stage may discard its pixel
    bool writes_depth = false;       // gl_FragDepth
    bool writes_point_size = false;  // gl_PointSize, in the vertex stage
    bool states_local_size = true;   // a compute stage that declares its local size explicitly

    [[nodiscard]] const ShaderBinding* find(std::string_view name) const;  // searches set 1 only: the pass's
                                                                           // ports
};

struct ShaderModule {
    ShaderStage stage = ShaderStage::compute;
    std::vector<uint32_t> spirv;  // entry point "main"; passed spirv-val
};

// The program of one shader reference: a compute shader, or a vertex and a fragment stage.
struct ShaderProgram {
    std::string reference;  // as written in the graph
    std::vector<ShaderModule> modules;
    ShaderInterface interface;
    uint64_t content_hash = 0;  // hash of all compiled sources, including included files
};

// Indexed by reference. A program that failed to compile is present without modules: it was already reported,
// so later stages do not report it again.
using ShaderCatalog = std::map<std::string, ShaderProgram, std::less<>>;

}  // namespace weft
