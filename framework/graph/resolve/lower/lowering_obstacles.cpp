#include "graph/resolve/lower/lowering_obstacles.h"

#include <algorithm>

#include "graph/resolve/evaluator.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/live/live_size.h"
#include "graph/resolve/lower/named_index.h"
#include "graph/resolve/pass_ports.h"
#include "graph/resolve/views/view_lists.h"

namespace weft {
namespace {

// The list of views that the program computes for the cascades of the sun. None of them is a mirror image.
constexpr const char* kSunViews = "sun";
constexpr uint32_t kFrameSetNumber = 0;

// Returns an obstacle without a reason. It stands for a fault of the graph that has nothing to do with the
// lowering, and that a later stage reports.
LoweringObstacle fault() {
    return {};
}

std::optional<LoweringObstacle> repeat_obstacle(const PassDesc& desc) {
    if (!desc.group.empty())
        return LoweringObstacle{"the pass belongs to a group", "move the pass out of the group"};
    if (desc.repeat.size() > 1)
        return LoweringObstacle{"the pass has a \"repeat\" too",
                                "write one pass for each value of the index of the repeat"};
    if (!desc.per_frame.empty())
        return LoweringObstacle{"with \"perFrame\", each frame draws only some of the views",
                                "remove \"perFrame\""};
    return std::nullopt;
}

// Returns an obstacle if an expression of the pass, a member of `Params` or a specialisation constant depends
// on the number of the view. If one pass draws all views, only view.number in the shader can differ between
// the views.
std::optional<LoweringObstacle> index_obstacle(const LoweringParts& parts) {
    const std::string remedy =
        "read the number of the view from view.number in the shader, see frame_set.glsl";
    if (const std::string place = place_of_index(parts.desc, kViewIndex); !place.empty())
        return LoweringObstacle{place + " depends on the number of the view", remedy};
    const auto given = [](const std::vector<ParamValueDesc>& values) {
        return std::ranges::find(values, kViewIndex, &ParamValueDesc::name) != values.end();
    };
    const auto& members = parts.shader.params.members;
    if (std::ranges::find(members, kViewIndex, &BlockMember::name) != members.end() &&
        !given(parts.desc.params))
        return LoweringObstacle{"the shader has the member Params.view, the number of the view", remedy};
    const auto& constants = parts.shader.spec_constants;
    if (std::ranges::find(constants, kViewIndex, &SpecConstant::name) != constants.end() &&
        !given(parts.desc.constants))
        return LoweringObstacle{"the shader has the constant \"view\", the number of the view", remedy};
    return std::nullopt;
}

// Checks that view i is drawn to layer first + i, where `first` is the layer of view 0.
std::optional<LoweringObstacle> layer_obstacle(const LoweringParts& parts, const PortDesc& port,
                                               const ResourceDecl& image, Reporter& reporter) {
    const RefDesc& ref = port.ref;
    if (!ref.layer_first) return std::nullopt;
    const LoweringObstacle irregular{
        quote(ref.text) + " does not select successive layers, one for each view",
        "select the layers by the number of the view, for example " + quote(ref.name + ".layer(6 + view)")};
    if (ref.layer_last) return irregular;
    Diagnostics warnings;
    Reporter quiet(parts.input.graph, parts.input.limits.steps, warnings);
    reporter.spend(parts.list.count, ref.loc);
    double first = 0;
    for (uint32_t view = 0; view < parts.list.count; ++view) {
        const std::map<std::string, double> index{{kViewIndex, double(view)}};
        const Evaluator evaluator(parts.values, parts.shapes, parts.shapes.suspects, quiet);
        const std::optional<ExprValue> layer = evaluator.in_repeat(index, true).value(*ref.layer_first);
        if (!layer || layer->is_size) return fault();
        if (view == 0) first = layer->x;
        if (layer->x != first + view) return irregular;
    }
    if (first < 0 || first + parts.list.count > image.layers) return fault();
    return std::nullopt;
}

// Returns true if a live scale (a parameter that multiplies a size and may change in every frame) changes the
// size of the image.
bool is_live(const LoweringParts& parts, ResourceId image) {
    const ResourceDesc* desc = parts.shapes.origins[image].desc;
    return desc != nullptr && !desc->is_buffer && has_live_size(parts.input, parts.values, *desc);
}

std::optional<LoweringObstacle> attachment_obstacle(const LoweringParts& parts, Reporter& reporter) {
    for (const PortDesc* port : written_ports(parts.desc)) {
        const bool is_depth = parts.desc.depth && port == &*parts.desc.depth;
        const auto& outputs = parts.shader.fragment_outputs;
        const bool is_color = std::ranges::find(outputs, port->port, &StageVariable::name) != outputs.end();
        const ResourceId id = resource_id(parts.shapes.resources, port->ref.name);
        if (id == kNoId || parts.shapes.suspects.shapes[id]) return fault();
        const ResourceDecl& resource = parts.shapes.resources[id];
        if (is_live(parts, id))
            return LoweringObstacle{quote(resource.name) + " has a live size",
                                    "give this image a size without a scale"};
        if (resource.samples > 1)
            return LoweringObstacle{quote(resource.name) + " is multisampled", "draw it with one sample"};
        if (!is_depth && !is_color)
            return LoweringObstacle{"the views write " + quote(resource.name) +
                                        " one after the other, because it is no attachment",
                                    "write only attachments in this pass"};
        if (resource.kind != ResourceKind::image) return fault();
        if (!port->ref.pass.empty() && port->ref.pass == parts.desc.name) return fault();
        if (auto found = layer_obstacle(parts, *port, resource, reporter)) return found;
    }
    for (const PortDesc& port : parts.desc.in)
        if (port.ref.pass == parts.desc.name)
            return LoweringObstacle{quote(port.ref.text) + " reads what the pass itself writes",
                                    "name another pass after @"};
    return std::nullopt;
}

// Returns true if, in every frame, either all views of the list are mirror images or none of them is. For
// lists of the program, this is certain only for the views of the sun, because the program may change the
// matrices of other lists at any time. For example, lamps with one view and lamps with six views differ in
// whether their views are mirror images.
bool has_one_winding(const Values& values, const std::string& base) {
    const auto list = values.views.find(base);
    if (list == values.views.end() || list->second.single) return true;
    switch (list->second.decl.source) {
        case ViewSource::program:
            return base == kSunViews;
        case ViewSource::mirror:
            return has_one_winding(values, list->second.decl.of);
        case ViewSource::cube:
        case ViewSource::buffer:
            break;
    }
    return true;
}

}  // namespace

std::optional<LoweringObstacle> one_pass_obstacle(const LoweringParts& parts, Reporter& reporter) {
    if (auto found = repeat_obstacle(parts.desc)) return found;
    if (find_view_buffer(parts.input, parts.list) != nullptr)
        return LoweringObstacle{"the views are in a buffer, and each view is an input of its own",
                                "choose \"passes\""};
    if (auto found = index_obstacle(parts)) return found;
    return attachment_obstacle(parts, reporter);
}

std::optional<LoweringObstacle> multiview_obstacle(const LoweringParts& parts) {
    const uint32_t most = parts.input.profile.max_multiview_views;
    if (parts.list.count > most)
        return LoweringObstacle{
            "the list has " + std::to_string(parts.list.count) + " views, and one draw of the device draws " +
                (most <= 1 ? "one view (maxMultiviewViews is " + std::to_string(most) + ")"
                           : "up to " + std::to_string(most) + " views (maxMultiviewViews)"),
            most <= 1 ? "choose \"passes\"" : "divide the list into parts with \"first\" and \"count\""};
    if (parts.desc.type == "raster" && !has_one_winding(parts.values, parts.list.base))
        return LoweringObstacle{"some of the views of " + quote(parts.list.base) +
                                    " may be mirror images and others not, but one "
                                    "draw has one winding",
                                "choose \"layerOutput\" or \"passes\""};
    return std::nullopt;
}

std::optional<LoweringObstacle> layer_output_obstacle(const LoweringParts& parts) {
    const uint32_t most = parts.input.profile.max_output_layers;
    if (most <= 1)
        return LoweringObstacle{
            "vertex shaders of the device cannot select a layer (maxOutputLayers is below 2, the "
            "feature shaderOutputLayer is missing)",
            "choose \"multiview\" or \"passes\""};
    if (parts.list.count > most)
        return LoweringObstacle{"the list has " + std::to_string(parts.list.count) +
                                    " views, and a pass of the device has at most " + std::to_string(most) +
                                    " layers (maxOutputLayers)",
                                "divide the list into parts with \"first\" and \"count\""};
    const bool reads_view = std::ranges::any_of(parts.shader.bindings, [](const ShaderBinding& binding) {
        return binding.set == kFrameSetNumber && binding.binding == kViewBinding;
    });
    if (!reads_view)
        return LoweringObstacle{"the shader " + quote(parts.desc.shader) +
                                    " does not read `view`, whose constants contain the number of the layer",
                                "choose \"multiview\" or \"passes\""};
    return std::nullopt;
}

}  // namespace weft
