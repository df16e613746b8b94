#include "graph/resolve/size_dispatches.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "graph/diagnostics/quantity_text.h"
#include "graph/resolve/check/check_copy.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/pass_ports.h"
#include "graph/resolve/pass_stage.h"

namespace weft {
namespace {

// The largest number of workgroups in one dimension that every Vulkan device supports: the required minimum
// of maxComputeWorkGroupCount.
constexpr double kMaxGroups = 65535;

// Returns true if the elements of a buffer are floats. Such a buffer cannot contain workgroup counts or draw
// commands.
bool holds_floats(const Shapes& shapes, ResourceId resource) {
    const ResourceDesc* desc = shapes.origins[resource].desc;
    if (desc == nullptr || !desc->is_buffer) return false;
    return desc->element == "f32" || desc->element == "mat4" || desc->element.starts_with("vec");
}

class DispatchSizer : PassStage<Dispatches> {
 public:
    using PassStage::PassStage;

    void run() {
        check_local_size();
        const PassDesc& desc = *draft_.desc;
        if (desc.indirect) return count_indirectly();
        std::optional<std::array<double, 3>> groups;
        if (!desc.groups.empty() && !desc.threads.empty()) {
            error(desc.groups.front().loc,
                  "pass " + quote(draft_.decl.name) + " has both \"groups\" and \"threads\"",
                  "remove one of the two");
            return;
        }
        if (!desc.groups.empty()) {
            groups = evaluate_sides(desc.groups);
        } else if (!desc.threads.empty()) {
            groups = in_groups(evaluate_sides(desc.threads));
        } else {
            groups = in_groups(output_threads());
        }
        if (groups) store(*groups);
    }

 private:
    void error(SourceLoc loc, const std::string& message, const std::string& help) {
        add_help(report(loc, "W114", message), help);
    }

    void count_indirectly() {
        constexpr uint64_t kCountsBytes = 12;  // Three 32-bit group counts.
        const auto port = std::ranges::find_if(bound_.ports, &PortDraft::is_indirect);
        // If the port is missing, bind() has already reported an error.
        if (port == bound_.ports.end()) return;
        result_.indirect_use = static_cast<uint32_t>(port - bound_.ports.begin());
        const UseDecl& use = bound_.uses[result_.indirect_use];
        const ResourceDecl& resource = graph_.resources[use.resource];
        const bool buffer = resource.kind == ResourceKind::buffer;
        const bool floats = holds_floats(declared_.shapes, use.resource);
        if (suspects_.shapes[use.resource] || (buffer && !floats && resource.size_bytes >= kCountsBytes))
            return;
        error(use.loc,
              "pass " + quote(draft_.decl.name) + " reads its numbers of workgroups from " +
                  quote(resource.name) +
                  (!buffer  ? ", which is an image"
                   : floats ? ", whose elements are floats"
                            : ", which is too small"),
              "use a buffer of three words: { \"buffer\": \"u32\", \"count\": 3 }");
    }

    void check_local_size() {
        const auto& local = draft_.shader->local_size;
        const uint64_t invocations = uint64_t{local[0]} * local[1] * local[2];
        const uint32_t limit = declared_.input.profile.max_workgroup_invocations;
        if (invocations <= limit) return;
        error(draft_.desc->shader_loc,
              "shader " + quote(draft_.desc->shader) + " has workgroups of " + std::to_string(invocations) +
                  " invocations; the device allows at most " + std::to_string(limit),
              "make local_size in the shader smaller");
    }

    // Returns the three sides of a dispatch, in the unit of `sides`: workgroups for "groups", shader
    // invocations for "threads". A single number n means (n, 1, 1), a size means (x, y, 1), and an array
    // gives each side.
    std::optional<std::array<double, 3>> evaluate_sides(const std::vector<Expr>& sides) {
        std::array<double, 3> result{1, 1, 1};
        for (size_t i = 0; i < std::min<size_t>(3, sides.size()); ++i) {
            const std::optional<ExprValue> value = evaluator_.value(sides[i]);
            if (!value) return std::nullopt;
            if (value->is_size && sides.size() > 1) {
                error(sides[i].loc,
                      "the dispatch size of pass " + quote(draft_.decl.name) +
                          " must be a list of numbers, but contains a size",
                      "use .x or .y of the size");
                return std::nullopt;
            }
            result[i] = value->x;
            if (value->is_size) result[1] = value->y;
        }
        return result;
    }

    std::optional<std::array<double, 3>> in_groups(std::optional<std::array<double, 3>> threads) const {
        if (!threads) return std::nullopt;
        for (size_t i = 0; i < 3; ++i)
            (*threads)[i] = std::ceil((*threads)[i] / draft_.shader->local_size[i]);
        return threads;
    }

    std::optional<std::array<double, 3>> output_threads() {
        std::set<std::array<uint32_t, 3>> extents;
        std::string listed;
        for (const UseDecl& use : bound_.uses) {
            if (!use.is_output) continue;
            if (suspects_.shapes[use.resource]) return std::nullopt;
            if (graph_.resources[use.resource].kind == ResourceKind::buffer) continue;
            const Extent3D e = use_extent(graph_.resources, use);
            if (extents.insert({e.width, e.height, std::max(e.depth, element_range(use, 0).layers)}).second) {
                listed += (listed.empty() ? "" : ", ") + quote(use.port) + " is " + extent_text(e);
            }
        }
        if (extents.size() == 1) {
            const auto& e = *extents.begin();
            return std::array<double, 3>{double(e[0]), double(e[1]), double(e[2])};
        }
        // The output that determines the dispatch size may be missing because of an error of this pass that
        // was already reported.
        if (suspects_.passes[pass_]) return std::nullopt;
        const std::string why =
            extents.empty() ? "the pass writes no image" : "its outputs differ in size: " + listed;
        error(draft_.decl.loc, "the dispatch size of pass " + quote(draft_.decl.name) + " is unknown: " + why,
              "add \"threads\": \"output\" (one invocation for each pixel of the output size) or \"groups\": "
              "[x, y, z] (numbers of workgroups)");
        return std::nullopt;
    }

    void store(const std::array<double, 3>& groups) {
        for (size_t i = 0; i < 3; ++i) {
            const double count = std::ceil(groups[i]);
            if (count < 1 || count > kMaxGroups) {
                const PassDesc& desc = *draft_.desc;
                const SourceLoc loc = !desc.groups.empty()    ? desc.groups.front().loc
                                      : !desc.threads.empty() ? desc.threads.front().loc
                                                              : desc.loc;
                error(loc,
                      "pass " + quote(draft_.decl.name) + " would run " + number_text(count) +
                          " workgroups in one dimension",
                      "choose a whole number from 1 to 65535");
                return;
            }
            result_.groups[i] = static_cast<uint32_t>(count);
        }
    }
};

// Finds the buffer with the draw commands of a raster pass, and checks that it has room for one command per
// draw of the draw list.
void find_draw_commands(const Declared& declared, const VersionedGraph& graph, PassId pass,
                        Dispatches& dispatches, PassReporter& report) {
    constexpr uint64_t kCommandBytes = 20;  // Five 32-bit words of an indexed draw command.
    const BoundPass& bound = graph.passes[pass];
    PassDispatch& dispatch = dispatches.passes[pass];
    const auto port = std::ranges::find_if(bound.ports, &PortDraft::is_indirect);
    if (port == bound.ports.end()) return;
    dispatch.draw_commands_use = static_cast<uint32_t>(port - bound.ports.begin());
    const UseDecl& use = bound.uses[dispatch.draw_commands_use];
    const ResourceDecl& resource = graph.resources[use.resource];
    if (dispatches.suspects.shapes[use.resource] || bound.draw_lists.empty()) return;
    const std::string& list = bound.draw_lists.front();
    const uint64_t draws = declared.input.imports.imports.at(list).draws;
    const bool buffer = resource.kind == ResourceKind::buffer;
    const bool floats = holds_floats(declared.shapes, use.resource);
    if (buffer && !floats && resource.size_bytes >= draws * kCommandBytes) return;
    Diagnostic& d = report.error(
        pass, use.loc, "W114",
        "pass " + quote(declared.pass_name(pass)) + " reads its draw commands from " + quote(resource.name) +
            (floats   ? std::string(", whose elements are floats")
             : buffer ? ", which has " + std::to_string(resource.size_bytes) + " bytes, but the " +
                            std::to_string(draws) + " draws of " + quote(list) + " need " +
                            std::to_string(draws * kCommandBytes)
                      : ", which is an image"));
    add_help(d, "use a buffer with one command for each draw: { \"buffer\": \"DrawCommand\", \"count\": \"" +
                    list + "Draws\" }");
}

}  // namespace

Dispatches size_dispatches(const Declared& declared, const VersionedGraph& graph, Suspects suspects,
                           Reporter& reporter) {
    Dispatches dispatches{.passes = std::vector<PassDispatch>(graph.passes.size()),
                          .suspects = std::move(suspects)};
    PassReporter report(declared.shapes, declared.expansion, dispatches.suspects, reporter);
    for (PassId pass(0); pass < graph.passes.size(); ++pass) {
        const PassDraft& draft = declared.expansion.passes[pass];
        if (draft.decl.kind == PassKind::compute && draft.shader)
            DispatchSizer(declared, graph, pass, dispatches, reporter).run();
        if (draft.decl.kind == PassKind::raster)
            find_draw_commands(declared, graph, pass, dispatches, report);
        const bool copies = draft.decl.kind == PassKind::copy || draft.decl.kind == PassKind::blit;
        if (copies && !dispatches.suspects.passes[pass])
            check_copy(declared, graph, pass, dispatches.suspects, report);
    }
    return dispatches;
}

}  // namespace weft
