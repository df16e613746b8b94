// Purpose: reads the declarations in the SPIR-V of one stage with SPIRV-Cross: resources, parameters,
// specialisation constants, stage inputs and outputs. It also finds the words of the SPIR-V that contain the
// set and binding numbers and the locations, so that link_stages() can change them. Error W206: Weft does not
// support the declaration. The SPIR-V must come from the compiler, or must have passed spirv-val.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "shader/faults/interface_fault.h"
#include "weft/shader_interface.h"

namespace weft::shader {

// Index of the word in the SPIR-V that contains a number such as a binding or a location; nullopt if there is
// none.
using WordIndex = std::optional<uint32_t>;

struct ReflectedBinding {
    ShaderBinding binding;
    bool is_params = false;  // True for a uniform block that is named Params.
    // True if main() uses the resource, directly or in a function that main() calls. A use also counts if it
    // is in a branch that runs only for some values of a specialisation constant.
    bool used = false;
    WordIndex set_word;
    WordIndex binding_word;
};

// An input or output variable of a shader stage.
struct ReflectedVariable {
    StageVariable variable;
    uint32_t component = 0;    // First component of the location that the variable uses: 0 to 3.
    uint32_t columns = 1;      // Number of columns of a matrix; 1 for scalars and vectors.
    uint32_t array_count = 0;  // Number of array elements; 0 if the variable is not an array.
    bool used = false;
    WordIndex location_word;

    [[nodiscard]] uint32_t location_count() const { return columns * (array_count == 0 ? 1 : array_count); }
};

struct StageReflection {
    ShaderStage stage = ShaderStage::compute;
    std::vector<ReflectedBinding> bindings;
    std::vector<FrameRange> frame_ranges;  // ShaderInterface::frame_ranges of this stage alone.
    std::optional<ParamsBlock> push_constants;
    std::vector<SpecConstant> spec_constants;
    std::vector<ReflectedVariable> inputs;
    std::vector<ReflectedVariable> outputs;
    std::array<uint32_t, 3> local_size{1, 1, 1};
    bool discards = false;
    bool writes_depth = false;
    bool writes_point_size = false;
    bool needs_texture_tables = false;  // True if this stage needs texture tables; see ShaderInterface.
};

[[nodiscard]] StageReflection reflect_stage(ShaderStage stage, const std::vector<uint32_t>& spirv,
                                            InterfaceFaults& faults);

}  // namespace weft::shader
