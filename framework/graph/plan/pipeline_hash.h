// Purpose: computes a hash of everything that determines a pipeline: the SPIR-V of its shader stages,
// constants, fixed-function state, attachment formats and vertex streams. Passes with equal hashes (32
// hexadecimal digits), even of different plans, can share one pipeline if the same draw source provides their
// layouts of descriptor sets 0, 2 and 3.
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
