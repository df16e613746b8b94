// Purpose: lists the fields of a compiled shader, as plan_fields.h lists those of a plan.
#pragma once

#include "weft/shader_interface.h"

namespace weft {

template <class V>
void visit_fields(V& v, const BlockMember& x) {
    v("name", x.name), v("offsetBytes", x.offset_bytes), v("sizeBytes", x.size_bytes), v("scalar", x.scalar);
    v("rows", x.rows), v("columns", x.columns), v("arrayCount", x.array_count),
        v("arrayStrideBytes", x.array_stride_bytes);
    v("isRuntimeArray", x.is_runtime_array), v("structName", x.struct_name), v("members", x.members);
}
template <class V>
void visit_fields(V& v, const ShaderBinding& x) {
    v("name", x.name), v("set", x.set), v("binding", x.binding), v("kind", x.kind), v("stages", x.stages);
    v("count", x.count), v("isArray", x.is_array), v("isRuntimeArray", x.is_runtime_array), v("dim", x.dim),
        v("arrayed", x.arrayed);
    v("multisampled", x.multisampled), v("shadow", x.shadow), v("filters", x.filters),
        v("numeric", x.numeric), v("storageFormat", x.storage_format);
    v("reads", x.reads), v("writes", x.writes), v("blockBytes", x.block_bytes), v("members", x.members);
}
template <class V>
void visit_fields(V& v, const ParamsBlock& x) {
    v("pushConstants", x.push_constants), v("binding", x.binding), v("sizeBytes", x.size_bytes),
        v("stages", x.stages), v("members", x.members);
}
template <class V>
void visit_fields(V& v, const SpecConstant& x) {
    v("name", x.name), v("id", x.id), v("type", x.type), v("defaultBits", x.default_bits);
}
template <class V>
void visit_fields(V& v, const StageVariable& x) {
    v("name", x.name), v("location", x.location), v("scalar", x.scalar), v("components", x.components);
}
template <class V>
void visit_fields(V& v, const FrameRange& x) {
    v("binding", x.binding), v("offsetBytes", x.offset_bytes), v("sizeBytes", x.size_bytes);
}
template <class V>
void visit_fields(V& v, const ShaderInterface& x) {
    v("stages", x.stages), v("bindings", x.bindings), v("frameRanges", x.frame_ranges),
        v("hasParams", x.has_params), v("params", x.params);
    v("specConstants", x.spec_constants), v("vertexInputs", x.vertex_inputs),
        v("fragmentOutputs", x.fragment_outputs), v("localSize", x.local_size);
    v("discards", x.discards), v("writesDepth", x.writes_depth), v("writesPointSize", x.writes_point_size),
        v("statesLocalSize", x.states_local_size), v("needsTextureTables", x.needs_texture_tables);
}
template <class V>
void visit_fields(V& v, const ShaderModule& x) {
    v("stage", x.stage), v("spirv", x.spirv);
}
template <class V>
void visit_fields(V& v, const ShaderProgram& x) {
    v("reference", x.reference), v("modules", x.modules), v("interface", x.interface),
        v("contentHash", x.content_hash);
}

}  // namespace weft
