// Purpose: lists the fields of a plan once. The hash of a plan and its JSON dump both use this list.
// visit_fields() calls the visitor as visitor("name", field) for each member of a struct. A field can also be
// a struct, vector, array or optional; then the visitor itself must visit the content of the field.
// Two things are deliberately left out: positions in source files (`loc`, SourceMap), and the default number
// of frames of a run (ResolvedGraph::frames).
#pragma once

#include "weft/plan.h"

namespace weft {

template <class V>
void visit_fields(V& v, const Extent3D& x) {
    v("width", x.width), v("height", x.height), v("depth", x.depth);
}
template <class V>
void visit_fields(V& v, const SubresourceRange& x) {
    v("mip", x.mip), v("mips", x.mips), v("layer", x.layer), v("layers", x.layers), v("aspects", x.aspects);
}
template <class V>
void visit_fields(V& v, const ByteRange& x) {
    v("offsetBytes", x.offset_bytes), v("sizeBytes", x.size_bytes);
}
template <class V>
void visit_fields(V& v, const AccessState& x) {
    v("stages", x.stages), v("access", x.access), v("layout", x.layout);
}
template <class V>
void visit_fields(V& v, const ImportState& x) {
    v("entry", x.entry), v("exit", x.exit), v("family", x.family), v("concurrent", x.concurrent);
}
template <class V>
void visit_fields(V& v, const TextureFile& x) {
    v("name", x.name), v("widthPx", x.width_px), v("heightPx", x.height_px), v("mips", x.mips);
}
template <class V>
void visit_fields(V& v, const ResourceDecl& x) {
    v("name", x.name), v("kind", x.kind), v("lifetime", x.lifetime), v("imageKind", x.image_kind);
    v("format", x.format), v("extent", x.extent), v("mips", x.mips), v("layers", x.layers),
        v("samples", x.samples);
    v("aspects", x.aspects), v("sizeBytes", x.size_bytes), v("strideBytes", x.stride_bytes),
        v("cutsBytes", x.cuts_bytes), v("usage", x.usage);
    v("history", x.history), v("ring", x.ring), v("age", x.age), v("firstFrame", x.first_frame);
    v("onResize", x.on_resize), v("shared", x.shared), v("preExposed", x.pre_exposed), v("import", x.import),
        v("between", x.between), v("clear", x.clear);
    v("file", x.file), v("textures", x.textures), v("textureFiles", x.texture_files), v("area", x.area);
}
template <class V>
void visit_fields(V& v, const VersionSource& x) {
    v("range", x.range), v("producer", x.producer);
}
template <class V>
void visit_fields(V& v, const SamplerDecl& x) {
    v("filter", x.filter), v("mipFilter", x.mip_filter), v("wrap", x.wrap);
    v("compare", x.compare), v("reduction", x.reduction), v("anisotropy", x.anisotropy);
    v("lodBias", x.lod_bias), v("minLod", x.min_lod), v("maxLod", x.max_lod);
}
template <class V>
void visit_fields(V& v, const UseDecl& x) {
    v("port", x.port), v("resource", x.resource), v("range", x.range), v("bytes", x.bytes),
        v("access", x.access), v("state", x.state);
    v("history", x.history), v("isOutput", x.is_output), v("sources", x.sources), v("binding", x.binding);
    v("sampler", x.sampler), v("wakes", x.wakes), v("latest", x.latest), v("each", x.each);
    v("usedIn", x.used_in), v("passesOn", x.passes_on);
}
template <class V>
void visit_fields(V& v, const EdgeDecl& x) {
    v("from", x.from), v("to", x.to), v("kind", x.kind), v("resource", x.resource);
}
template <class V>
void visit_fields(V& v, const BlendState& x) {
    v("enabled", x.enabled), v("srcColor", x.src_color), v("dstColor", x.dst_color), v("colorOp", x.color_op);
    v("srcAlpha", x.src_alpha), v("dstAlpha", x.dst_alpha), v("alphaOp", x.alpha_op),
        v("writeMask", x.write_mask);
}
template <class V>
void visit_fields(V& v, const StencilFaceState& x) {
    v("compare", x.compare), v("fail", x.fail), v("depthFail", x.depth_fail), v("pass", x.pass);
    v("readMask", x.read_mask), v("writeMask", x.write_mask), v("reference", x.reference);
}
template <class V>
void visit_fields(V& v, const RectPx& x) {
    v("x", x.x), v("y", x.y), v("width", x.width), v("height", x.height);
}
template <class V>
void visit_fields(V& v, const RasterState& x) {
    v("topology", x.topology), v("fill", x.fill), v("cull", x.cull), v("frontFace", x.front_face);
    v("depthTest", x.depth_test), v("depthWrite", x.depth_write), v("depthCompare", x.depth_compare);
    v("depthClamp", x.depth_clamp), v("depthBiasConstant", x.depth_bias_constant);
    v("depthBiasSlope", x.depth_bias_slope), v("depthBiasClamp", x.depth_bias_clamp);
    v("stencilTest", x.stencil_test), v("stencilFront", x.stencil_front), v("stencilBack", x.stencil_back);
    v("alphaToCoverage", x.alpha_to_coverage), v("scissor", x.scissor), v("viewport", x.viewport);
}
template <class V>
void visit_fields(V& v, const AttachmentDecl& x) {
    v("use", x.use), v("location", x.location), v("resolveUse", x.resolve_use), v("blend", x.blend),
        v("clear", x.clear), v("covers", x.covers);
}
template <class V>
void visit_fields(V& v, const ParamWrite& x) {
    v("member", x.member), v("offsetBytes", x.offset_bytes), v("scalar", x.scalar),
        v("components", x.components);
    v("builtin", x.builtin), v("resource", x.resource), v("use", x.use), v("value", x.value),
        v("live", x.live);
}
template <class V>
void visit_fields(V& v, const LiveStep& x) {
    v("op", x.op), v("number", x.number), v("value", x.value);
}
template <class V>
void visit_fields(V& v, const LiveValue& x) {
    v("name", x.name), v("param", x.param), v("least", x.least), v("most", x.most), v("steps", x.steps),
        v("scale", x.scale);
}
template <class V>
void visit_fields(V& v, const LiveArea& x) {
    v("image", x.image), v("mip", x.mip);
}
template <class V>
void visit_fields(V& v, const LiveCount& x) {
    v("value", x.value), v("side", x.side), v("mip", x.mip), v("per", x.per);
}
template <class V>
void visit_fields(V& v, const LiveSide& x) {
    v("scissor", x.scissor), v("side", x.side), v("value", x.value);
}
template <class V>
void visit_fields(V& v, const SpecValue& x) {
    v("id", x.id), v("type", x.type), v("bits", x.bits);
}
template <class V>
void visit_fields(V& v, const PassVariant& x) {
    v("combinations", x.combinations), v("specValues", x.spec_values), v("params", x.params);
}
template <class V>
void visit_fields(V& v, const SwitchDecl& x) {
    v("param", x.param);
}
template <class V>
void visit_fields(V& v, const NamedValue& x) {
    v("name", x.name), v("value", x.value);
}
template <class V>
void visit_fields(V& v, const GraphParam& x) {
    v("name", x.name), v("value", x.value), v("cost", x.cost);
}
template <class V>
void visit_fields(V& v, const PassDecl& x) {
    v("name", x.name), v("type", x.type), v("kind", x.kind), v("queue", x.queue), v("uses", x.uses);
    v("sideEffect", x.side_effect), v("shader", x.shader), v("specValues", x.spec_values),
        v("params", x.params);
    v("paramsBytes", x.params_bytes), v("paramsPush", x.params_push), v("customParams", x.custom_params);
    v("groups", x.groups), v("indirectUse", x.indirect_use), v("colors", x.colors), v("depth", x.depth),
        v("renderExtent", x.render_extent);
    v("state", x.state), v("drawLists", x.draw_lists), v("vertices", x.vertices), v("instances", x.instances),
        v("view", x.view), v("views", x.views), v("lowering", x.lowering),
        v("loweringReason", x.lowering_reason), v("cullsDraws", x.culls_draws), v("clear", x.clear),
        v("flops", x.flops);
    v("orderKey", x.order_key), v("drawCommandsUse", x.draw_commands_use),
        v("drawCountUse", x.draw_count_use), v("mostDraws", x.most_draws), v("viewUse", x.view_use);
    v("frameSlice", x.frame_slice), v("frameSlices", x.frame_slices), v("restUnit", x.rest_unit),
        v("carries", x.carries);
    v("area", x.area), v("liveGroups", x.live_groups), v("liveSides", x.live_sides), v("switch", x.switch_id),
        v("runsIn", x.runs_in), v("variants", x.variants);
}
template <class V>
void visit_fields(V& v, const GroupDecl& x) {
    v("name", x.name), v("firstUnit", x.first_unit), v("rounds", x.rounds), v("perFrame", x.per_frame);
    v("warmUp", x.warm_up), v("rests", x.rests), v("settle", x.settle), v("turns", x.turns);
}
template <class V>
void visit_fields(V& v, const ViewListDecl& x) {
    v("name", x.name), v("source", x.source), v("count", x.count), v("of", x.of), v("first", x.first);
    v("plane", x.plane), v("at", x.at), v("nearM", x.near_m);
}
template <class V>
void visit_fields(V& v, const ResolvedGraph& x) {
    v("name", x.name), v("outputExtent", x.output_extent), v("resources", x.resources), v("passes", x.passes);
    v("edges", x.edges), v("output", x.output), v("params", x.params), v("restUnitCount", x.rest_unit_count);
    v("groups", x.groups), v("views", x.views), v("liveValues", x.live_values), v("switches", x.switches);
}
template <class V>
void visit_fields(V& v, const LiveGraph& x) {
    v("livePasses", x.live_passes), v("liveResources", x.live_resources), v("retained", x.retained);
    v("reasons", x.reasons), v("details", x.details);
}
template <class V>
void visit_fields(V& v, const ScheduleCandidate& x) {
    v("name", x.name), v("peakLiveBytes", x.peak_live_bytes), v("barrierBatches", x.barrier_batches);
    v("queueSwitches", x.queue_switches);
}
template <class V>
void visit_fields(V& v, const LogicalQueue& x) {
    v("kind", x.kind), v("family", x.family);
}
template <class V>
void visit_fields(V& v, const Schedule& x) {
    v("order", x.order), v("position", x.position), v("queue", x.queue), v("clocks", x.clocks);
    v("candidates", x.candidates), v("chosen", x.chosen), v("queues", x.queues);
}
template <class V>
void visit_fields(V& v, const QueueSpan& x) {
    v("queue", x.queue), v("first", x.first), v("last", x.last);
}
template <class V>
void visit_fields(V& v, const LifetimeSpan& x) {
    v("first", x.first), v("last", x.last), v("queues", x.queues);
}
template <class V>
void visit_fields(V& v, const Lifetimes& x) {
    v("spans", x.spans);
}
template <class V>
void visit_fields(V& v, const Placement& x) {
    v("resource", x.resource), v("heap", x.heap), v("offsetBytes", x.offset_bytes),
        v("sizeBytes", x.size_bytes);
}
template <class V>
void visit_fields(V& v, const AliasTransition& x) {
    v("from", x.from), v("to", x.to), v("wrap", x.wrap);
}
template <class V>
void visit_fields(V& v, const HeapPlan& x) {
    v("sizeBytes", x.size_bytes), v("typeBits", x.type_bits), v("buffers", x.buffers),
        v("persistent", x.persistent), v("shared", x.shared);
}
template <class V>
void visit_fields(V& v, const MemoryPlan& x) {
    v("heaps", x.heaps), v("placements", x.placements), v("aliasTransitions", x.alias_transitions),
        v("sumBytes", x.sum_bytes);
    v("peakLiveBytes", x.peak_live_bytes), v("peakPosition", x.peak_position), v("heapBytes", x.heap_bytes);
    v("persistentBytes", x.persistent_bytes);
}
template <class V>
void visit_fields(V& v, const AttachmentOps& x) {
    v("use", x.use), v("load", x.load), v("store", x.store);
}
template <class V>
void visit_fields(V& v, const BarrierDecl& x) {
    v("resource", x.resource), v("range", x.range), v("src", x.src), v("dst", x.dst),
        v("srcFamily", x.src_family);
    v("dstFamily", x.dst_family), v("reason", x.reason), v("from", x.from), v("to", x.to);
    v("fromPreviousFrame", x.from_previous_frame), v("aliasedFrom", x.aliased_from);
    v("ifPassRuns", x.if_pass_runs);
}
template <class V>
void visit_fields(V& v, const PassStep& x) {
    v("pass", x.pass), v("barriers", x.barriers), v("after", x.after), v("attachments", x.attachments);
    v("mergesRenderPass", x.merges_render_pass);
}
template <class V>
void visit_fields(V& v, const ProloguePlan& x) {
    v("before", x.before), v("cleared", x.cleared), v("after", x.after);
}
template <class V>
void visit_fields(V& v, const BarrierPlan& x) {
    v("steps", x.steps), v("epilogue", x.epilogue), v("prologue", x.prologue), v("concurrent", x.concurrent);
    v("emitted", x.emitted);
}
template <class V>
void visit_fields(V& v, const QueueDependency& x) {
    v("from", x.from), v("to", x.to), v("previousFrame", x.previous_frame), v("resource", x.resource);
}
template <class V>
void visit_fields(V& v, const QueueWait& x) {
    v("batch", x.batch), v("previousFrame", x.previous_frame), v("dependency", x.dependency);
}
template <class V>
void visit_fields(V& v, const Batch& x) {
    v("queue", x.queue), v("positions", x.positions), v("waits", x.waits), v("epilogue", x.epilogue);
}
template <class V>
void visit_fields(V& v, const SubmissionPlan& x) {
    v("batches", x.batches), v("dependencies", x.dependencies);
}
template <class V>
void visit_fields(V& v, const BoundaryState& x) {
    v("resource", x.resource), v("range", x.range), v("state", x.state), v("family", x.family);
}
template <class V>
void visit_fields(V& v, const FramePlan& x) {
    v("graph", x.graph), v("live", x.live), v("schedule", x.schedule), v("lifetimes", x.lifetimes);
    v("memory", x.memory), v("barriers", x.barriers), v("submissions", x.submissions),
        v("boundary", x.boundary);
}

}  // namespace weft
