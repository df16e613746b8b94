#include "graph/resolve/lower/choose_lowering.h"

#include "graph/resolve/fault_text.h"
#include "graph/resolve/lower/lowering_obstacles.h"

namespace weft {
namespace {

using Obstacle = std::optional<LoweringObstacle>;

// Returns true if the draw source may leave out direct draws of the pass, see PassDecl::culls_draws.
bool leaves_out_draws(const PassDesc& desc) {
    const Topology topology = desc.state.topology;
    return desc.frustum && desc.type == "raster" && !desc.draws.empty() && !desc.indirect &&
           desc.state.fill == FillMode::fill &&
           (topology == Topology::triangles || topology == Topology::triangle_strip);
}

std::string not_possible(const char* lowering, const Obstacle& obstacle) {
    return std::string(lowering) + " is not possible: " + obstacle->reason;
}

ChosenLowering asked(const LoweringParts& parts, const char* name, ViewLowering kind,
                     const Obstacle& obstacle, Reporter& reporter) {
    if (!obstacle) return {kind, parts.list.count, "the graph asks for it"};
    // An obstacle without a reason stands for a fault that another stage reports.
    if (obstacle->reason.empty()) return {};
    Diagnostic& d =
        reporter.error(parts.desc.lowering_loc, "W199",
                       "the views of pass " + quote(parts.desc.name) +
                           " cannot be drawn with the lowering \"" + name + "\": " + obstacle->reason);
    add_help(d, obstacle->remedy);
    add_help(d, "or remove \"lowering\", so that Weft chooses");
    return {};
}

ChosenLowering choose(const LoweringParts& parts, const Obstacle& both) {
    const uint32_t views = parts.list.count;
    if (views == 1) return {ViewLowering::none, 0, "the list has only one view"};
    if (both) return {ViewLowering::none, 0, both->reason};
    const Obstacle output = layer_output_obstacle(parts), multiview = multiview_obstacle(parts);
    const bool leaves_out = leaves_out_draws(parts.desc);
    if (leaves_out && !output)
        return {ViewLowering::layer_output, views, "draws outside of a view are left out for each view"};
    const std::string no_output =
        leaves_out ? not_possible("layerOutput", output) : "no draws are left out, which layerOutput is for";
    if (!multiview) return {ViewLowering::multiview, views, no_output};
    return {ViewLowering::none, 0, no_output + "; " + not_possible("multiview", multiview)};
}

}  // namespace

ChosenLowering choose_lowering(const ResolveInput& input, const Values& values, const Shapes& shapes,
                               const PassDesc& desc, Reporter& reporter) {
    const auto list = values.views.find(desc.view);
    const auto program = input.shaders.find(desc.shader);
    const bool is_faulty =
        list == values.views.end() || program == input.shaders.end() || program->second.modules.empty();
    if (is_faulty || list->second.count == 0) return {};
    if (desc.lowering == LoweringDesc::passes) return {ViewLowering::none, 0, "the graph asks for it"};
    const LoweringParts parts{input, values, shapes, desc, list->second, program->second.interface};
    const Obstacle both = one_pass_obstacle(parts, reporter);
    if (desc.lowering == LoweringDesc::multiview)
        return asked(parts, "multiview", ViewLowering::multiview, both ? both : multiview_obstacle(parts),
                     reporter);
    if (desc.lowering == LoweringDesc::layer_output)
        return asked(parts, "layerOutput", ViewLowering::layer_output,
                     both ? both : layer_output_obstacle(parts), reporter);
    return choose(parts, both);
}

}  // namespace weft
