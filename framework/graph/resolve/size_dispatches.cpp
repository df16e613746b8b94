#include "graph/resolve/size_dispatches.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "graph/diagnostics/quantity_text.h"
#include "graph/resolve/check/check_copy.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/fill/find_draw_commands.h"
#include "graph/resolve/pass_ports.h"
#include "graph/resolve/pass_stage.h"

namespace weft {
namespace {

// The largest number of workgroups in one dimension that every Vulkan device supports: the required minimum
// of maxComputeWorkGroupCount.
constexpr double kMaxGroups = 65535;

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
        const bool fits = used_bytes(resource, use).size_bytes >= kCountsBytes;
        if (suspects_.shapes[use.resource] || (buffer && !floats && fits)) return;
        error(use.loc,
              "pass " + quote(draft_.decl.name) + " reads its numbers of workgroups from " +
                  quote(range_of(resource, use.range)) +
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
