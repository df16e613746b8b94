#include "graph/plan/plan_names.h"

#include <array>

#include "graph/diagnostics/name_of_value.h"

namespace weft {

const char* enum_name(ResourceKind value) {
    return name_of_value(value, std::array{"image", "buffer"});
}

const char* enum_name(ResourceLifetime value) {
    return name_of_value(value, std::array{"transient", "persistent", "imported"});
}

const char* enum_name(ImageKind value) {
    return name_of_value(value, std::array{"d2", "d2_array", "cube", "cube_array", "d3"});
}

const char* enum_name(PassKind value) {
    return name_of_value(
        value, std::array{"compute", "fullscreen", "raster", "clear", "copy", "readback", "custom", "blit"});
}

const char* enum_name(ParamCost value) {
    return name_of_value(value, std::array{"nothing", "live value", "pipeline rebuild", "graph rebuild"});
}

const char* enum_name(QueueKind value) {
    return name_of_value(value, std::array{"graphics", "compute", "transfer"});
}

const char* enum_name(EdgeKind value) {
    return name_of_value(value, std::array{"raw", "war", "waw", "after"});
}

const char* enum_name(CullReason value) {
    return name_of_value(value, std::array{"live", "unused_output", "upstream_culled"});
}

const char* enum_name(LoadOp value) {
    return name_of_value(value, std::array{"load", "clear", "dont_care", "none"});
}

const char* enum_name(StoreOp value) {
    return name_of_value(value, std::array{"store", "dont_care", "none"});
}

const char* enum_name(BarrierReason value) {
    return name_of_value(value, std::array{"raw", "war", "waw", "layout", "alias", "acquire_import",
                                           "release_import", "release_queue", "acquire_queue", "prologue"});
}

const char* enum_name(ViewSource value) {
    return name_of_value(value, std::array{"program", "mirror", "cube", "buffer"});
}

const char* enum_name(ViewLowering value) {
    return name_of_value(value, std::array{"none", "multiview", "layerOutput"});
}

const char* enum_name(OnResize value) {
    return name_of_value(value, std::array{"clear", "resample", "refill"});
}

const char* enum_name(EachPart value) {
    return name_of_value(value, std::array{"none", "mip", "layer"});
}

const char* enum_name(SamplerFilter value) {
    return name_of_value(value, std::array{"nearest", "linear"});
}

const char* enum_name(SamplerReduction value) {
    return name_of_value(value, std::array{"average", "min", "max"});
}

const char* enum_name(SamplerWrap value) {
    return name_of_value(value, std::array{"clamp", "repeat", "mirror", "border"});
}

const char* enum_name(CompareOp value) {
    return name_of_value(value, std::array{"never", "less", "equal", "less_equal", "greater", "not_equal",
                                           "greater_equal", "always"});
}

const char* enum_name(CullMode value) {
    return name_of_value(value, std::array{"none", "front", "back", "material"});
}

const char* enum_name(FrontFace value) {
    return name_of_value(value, std::array{"counter_clockwise", "clockwise"});
}

const char* enum_name(Topology value) {
    return name_of_value(value, std::array{"triangles", "triangle_strip", "lines", "line_strip", "points"});
}

const char* enum_name(FillMode value) {
    return name_of_value(value, std::array{"fill", "line", "point"});
}

const char* enum_name(BlendFactor value) {
    return name_of_value(value, std::array{"zero", "one", "src_color", "one_minus_src_color", "dst_color",
                                           "one_minus_dst_color", "src_alpha", "one_minus_src_alpha",
                                           "dst_alpha", "one_minus_dst_alpha"});
}

const char* enum_name(BlendOp value) {
    return name_of_value(value, std::array{"add", "subtract", "reverse_subtract", "min", "max"});
}

const char* enum_name(StencilOp value) {
    return name_of_value(value, std::array{"keep", "zero", "replace", "increment_clamp", "decrement_clamp",
                                           "invert", "increment_wrap", "decrement_wrap"});
}

const char* enum_name(Builtin value) {
    return name_of_value(value, std::array{"none", "frame_index", "time_s", "delta_time_s", "pre_exposure",
                                           "prev_pre_exposure", "valid", "unit_valid", "unit_bits", "live",
                                           "area_size", "area_uv", "area_uv_most"});
}

const char* enum_name(ExprOp value) {
    return name_of_value(value, std::array{"number", "name", "mips", ".x", ".y", "+", "-", "*", "/", "%",
                                           "negate", "min", "max", "ceil", "floor", "log2", "size"});
}

const char* enum_name(ScalarType value) {
    return name_of_value(value, std::array{"f32", "i32", "u32", "boolean"});
}

}  // namespace weft
