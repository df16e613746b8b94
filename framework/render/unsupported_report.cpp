#include "render/unsupported_report.h"

#include <algorithm>
#include <set>

#include "shared/light.glsl"
#include "weft/render/import_catalog.h"

namespace weft::render {
namespace {

constexpr size_t kMaxNamed = 4;

std::set<std::string> drawn_lists(const FramePlan& plan) {
    std::set<std::string> lists;
    for (const PassId id : plan.schedule.order) {
        const PassDecl& pass = plan.graph.passes[id];
        lists.insert(pass.draw_lists.begin(), pass.draw_lists.end());
    }
    return lists;
}

// Returns the names of materials for a message. If there are more than kMaxNamed, the text ends in a count of
// the others, such as `and 3 more`.
std::string names_of(const std::set<uint32_t>& materials, const scene::Scene& scene) {
    std::string names;
    size_t named = 0;
    for (const uint32_t material : materials) {
        if (named == kMaxNamed) break;
        const std::string& name = scene.materials[material].name;
        names += (named++ == 0 ? "" : ", ") +
                 (name.empty() ? "material " + std::to_string(material) : "\"" + name + "\"");
    }
    if (materials.size() > named) names += " and " + std::to_string(materials.size() - named) + " more";
    return names;
}

Diagnostics report_lights(const FramePlan& plan, const scene::Scene& scene) {
    const auto lights = static_cast<uint64_t>(
        std::ranges::count_if(scene.lights, [](const scene::Light& light) { return light.intensity > 0; }));
    Diagnostics warnings;
    for (const PassId id : plan.schedule.order) {
        const PassDecl& pass = plan.graph.passes[id];
        if (pass.type != "light_upload") continue;
        for (const UseDecl& use : pass.uses) {
            const ResourceDecl& buffer = plan.graph.resources[use.resource];
            const uint64_t room = buffer.size_bytes / sizeof(shared::Light);
            if (room >= lights) continue;
            warnings.push_back(plan.graph.sources.error(
                buffer.loc, "S157",
                "the scene has " + std::to_string(lights) + " lights, but the buffer \"" + buffer.name +
                    "\" has space for only " + std::to_string(room) + "; the other lights are ignored"));
            warnings.back().severity = Severity::warning;
            warnings.back().help = {
                "raise the \"count\" of \"" + buffer.name +
                "\"; in the shipped graphs, use --param maxLights=" + std::to_string(lights)};
        }
    }
    return warnings;
}

Diagnostics report_transparent(const FramePlan& plan, const scene::Scene& scene) {
    const std::set<std::string> drawn = drawn_lists(plan);
    if (drawn.empty() || drawn.contains("transparent")) return {};
    std::set<uint32_t> materials;
    size_t objects = 0;
    for (const scene::Instance& instance : scene.instances) {
        if (!is_in_draw_list(instance, scene.materials[instance.material], "transparent")) continue;
        materials.insert(instance.material);
        ++objects;
    }
    if (objects == 0) return {};
    Diagnostic warning;
    warning.severity = Severity::warning;
    warning.code = "S155";
    warning.message =
        (objects == 1 ? "1 transparent object is" : std::to_string(objects) + " transparent objects are") +
        std::string(" not drawn (BLEND materials: ") + names_of(materials, scene) +
        "), because no pass of graph \"" + plan.graph.name + "\" draws the list \"transparent\"";
    warning.help = {"use a graph that draws transparent objects, for example --graph graphs/forward.json"};
    return {warning};
}

}  // namespace

Diagnostics report_unsupported(const FramePlan& plan, const scene::Scene& scene) {
    Diagnostics warnings = report_transparent(plan, scene);
    for (Diagnostic& warning : report_lights(plan, scene)) warnings.push_back(std::move(warning));
    return warnings;
}

}  // namespace weft::render
