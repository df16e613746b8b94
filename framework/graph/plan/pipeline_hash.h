// Purpose: computes a hash of the inputs of a pipeline: the SPIR-V of its shader stages, specialisation
// constants, fixed-function state, attachment formats and vertex streams. The hash does not contain the
// layouts of descriptor sets 0, 2 and 3, which a draw source provides. Passes with equal hashes (32
// hexadecimal digits) and the same draw source can share one pipeline, even if their plans differ.
#pragma once

#include <string>

#include "weft/declaration.h"
#include "weft/imports.h"
#include "weft/shader_interface.h"

namespace weft {

struct PipelineParts {
    const ResolvedGraph& graph;
    const PassDecl& pass;
    const ShaderProgram& program;
    const DrawVariant* variant = nullptr;    // Variant of the draw list, or null; its constants are hashed.
    const VertexFormat* vertices = nullptr;  // Vertex format of the draw list, or null.
};

[[nodiscard]] std::string pipeline_hash(const PipelineParts& parts);

}  // namespace weft
