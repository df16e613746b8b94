// Purpose: tells pipelines apart by what they are made of: the words of the shader's stages, constants,
// fixed-function state, formats and vertex streams. Equal hashes (32 hex digits): one pipeline serves both,
// whatever passes or plans they belong to, as long as one draw source gives the layouts of sets 0, 2 and 3.
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
    const DrawVariant* variant = nullptr;    // of a draw list; its constants count
    const VertexFormat* vertices = nullptr;  // of that list
};

[[nodiscard]] std::string pipeline_hash(const PipelineParts& parts);

}  // namespace weft
