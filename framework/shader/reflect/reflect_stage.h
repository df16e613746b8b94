// Purpose: reads the declarations of one stage's SPIR-V with SPIRV-Cross: resources, parameters,
// specialisation constants, stage inputs and outputs, and the positions of their numbers in the SPIR-V, so
// that linking can change them. Errors: W206 for declarations that Weft does not support. The SPIR-V must
// come from the compiler or have passed spirv-val.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "shader/faults/interface_fault.h"
#include "weft/shader_interface.h"

namespace weft::shader {

// Position of a decoration's number in the module's words.
using WordIndex = std::optional<uint32_t>;

struct ReflectedBinding {
    ShaderBinding binding;
    bool is_params = false;  // a uniform block named Params
    bool used = false;       // reachable from main() for some value of the specialisation constants
    WordIndex set_word;
    WordIndex binding_word;
};

// A stage input or output.
struct ReflectedVariable {
    StageVariable variable;
    uint32_t component = 0;
    uint32_t columns = 1;
    uint32_t array_count = 0;  // 0: not an array
    bool used = false;
    WordIndex location_word;

    [[nodiscard]] uint32_t location_count() const { return columns * (array_count == 0 ? 1 : array_count); }
};

struct StageReflection {
    ShaderStage stage = ShaderStage::compute;
    std::vector<ReflectedBinding> bindings;
    std::optional<ParamsBlock> push_constants;
    std::vector<SpecConstant> spec_constants;
    std::vector<ReflectedVariable> inputs;
    std::vector<ReflectedVariable> outputs;
    std::array<uint32_t, 3> local_size{1, 1, 1};
    bool discards = false;
    bool writes_depth = false;
    bool writes_point_size = false;
};

[[nodiscard]] StageReflection reflect_stage(ShaderStage stage, const std::vector<uint32_t>& spirv,
                                            InterfaceFaults& faults);

}  // namespace weft::shader
