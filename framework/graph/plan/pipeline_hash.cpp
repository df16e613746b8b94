#include "graph/plan/pipeline_hash.h"

#include "graph/plan/field_hash.h"

namespace weft {
namespace {

void add_program(HashVisitor& v, const ShaderProgram& program) {
    for (const ShaderModule& module : program.modules) v("stage", module.stage), v("words", module.spirv);
    // Specialisation constants and vertex inputs are matched by name. The names are hashed too, because the
    // SPIR-V words do not contain them.
    for (const SpecConstant& constant : program.interface.spec_constants)
        v("name", constant.name), v("id", constant.id);
    for (const StageVariable& input : program.interface.vertex_inputs)
        v("name", input.name), v("location", input.location);
}

void add_target(HashVisitor& v, const PipelineParts& parts, const AttachmentDecl& attachment) {
    const ResourceDecl& target = parts.graph.resources[parts.pass.uses[attachment.use].resource];
    v("location", attachment.location), v("blend", attachment.blend);
    v("format", target.format), v("samples", target.samples);
}

void add_state(HashVisitor& v, RasterState state) {
    // These four members are dynamic state of the pipeline: they are set while commands are recorded. So they
    // must not change the hash.
    state.cull = {};
    state.front_face = {};
    state.scissor.reset();
    state.viewport.reset();
    v("state", state);
}

}  // namespace

std::string pipeline_hash(const PipelineParts& parts) {
    return hash_fields([&](HashVisitor& v) {
        v("kind", parts.pass.kind);
        add_program(v, parts.program);
        v("specValues", parts.pass.spec_values);
        // The number of textures is a part of the pipeline layout.
        for (const UseDecl& use : parts.pass.uses)
            if (const uint32_t textures = parts.graph.resources[use.resource].textures; textures > 0)
                v("textures", textures);
        if (parts.variant != nullptr) v("variant", parts.variant->spec_constants);
        if (parts.vertices != nullptr) {
            v("strides", parts.vertices->stride_bytes);
            for (const VertexAttribute& attribute : parts.vertices->attributes) {
                v("name", attribute.name), v("format", attribute.format);
                v("stream", attribute.stream), v("offset", attribute.offset_bytes);
            }
        }
        if (parts.pass.kind == PassKind::compute) return;
        add_state(v, parts.pass.state);
        if (parts.pass.lowering == ViewLowering::multiview) v("views", parts.pass.views.size());
        for (const AttachmentDecl& color : parts.pass.colors) add_target(v, parts, color);
        v("depth", parts.pass.depth.has_value());
        if (parts.pass.depth) add_target(v, parts, *parts.pass.depth);
    });
}

}  // namespace weft
