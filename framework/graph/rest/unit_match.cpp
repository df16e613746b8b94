#include "graph/rest/unit_match.h"

#include <algorithm>
#include <string>
#include <utility>

#include "graph/plan/field_hash.h"

namespace weft {
namespace {

// Returns a hash of the declaration of a pass. The hash covers everything that affects the result of the
// pass, except the values of its Params. It contains the names of resources and passes instead of their ids,
// because the ids differ between plans.
std::string declaration_hash(const FramePlan& plan, PassId id) {
    PassDecl pass = plan.graph.passes[id];
    const std::vector<UseDecl> uses = std::exchange(pass.uses, {});
    pass.queue = QueueKind::graphics;
    pass.rest_unit = kNoId;
    pass.flops = 0;
    pass.order_key = 0;
    for (ParamWrite& param : pass.params) {
        param.resource = kNoId;
        param.value = {};
    }
    return hash_fields([&](HashVisitor& v) {
        v("pass", pass);
        for (const UseDecl& use : uses) {
            const ResourceDecl& resource = plan.graph.resources[use.resource];
            v("port", use.port), v("range", use.range), v("usedBytes", use.bytes), v("access", use.access),
                v("sampler", use.sampler), v("wakes", use.wakes), v("each", use.each);
            v("name", resource.name), v("kind", resource.kind), v("imageKind", resource.image_kind);
            v("format", resource.format), v("extent", resource.extent), v("mips", resource.mips);
            v("layers", resource.layers), v("samples", resource.samples), v("bytes", resource.size_bytes);
            v("cuts", resource.cuts_bytes);
            for (const VersionSource& source : use.sources) {
                v("range", source.range);
                v("producer",
                  source.producer == kNoId ? std::string() : plan.graph.passes[source.producer].name);
            }
        }
    });
}

// Returns the passes of each unit, in schedule order. Index: unit.
std::vector<std::vector<PassId>> passes_by_unit(const FramePlan& plan) {
    std::vector<std::vector<PassId>> units(plan.graph.rest_unit_count);
    for (const PassId pass : plan.schedule.order)
        if (plan.graph.passes[pass].rest_unit != kNoId)
            units[plan.graph.passes[pass].rest_unit].push_back(pass);
    return units;
}

class UnitMatch {
 public:
    UnitMatch(const FramePlan& old_plan, const FramePlan& new_plan, const TransitionPlan& transition,
              const SamePipelines& same_pipelines)
        : old_(old_plan),
          new_(new_plan),
          transition_(transition),
          same_pipelines_(same_pipelines),
          old_passes_(passes_by_unit(old_plan)),
          new_passes_(passes_by_unit(new_plan)),
          read_outside_(find_read_outside(new_plan)) {}

    [[nodiscard]] MatchedUnit match(uint32_t unit) const {
        const std::vector<PassId>& passes = new_passes_[unit];
        if (passes.empty()) return {};
        const PassId first = find_pass(old_.graph, new_.graph.passes[passes.front()].name);
        if (first == kNoId) return {};
        const uint32_t old_unit = old_.graph.passes[first].rest_unit;
        const auto keeps = [&](PassId pass) { return keeps_results(pass); };
        if (old_unit == kNoId || !std::ranges::all_of(passes, keeps)) return {};
        const bool same = old_passes_[old_unit].size() == passes.size() &&
                          std::ranges::all_of(passes, [&](PassId pass) { return is_same(pass, old_unit); });
        return {same ? old_unit : uint32_t{kNoId}, old_unit};
    }

 private:
    // For each transient resource (index: ResourceId), returns 1 if a pass outside the writing unit uses the
    // resource. Such a pass may run in a frame in which the unit does not run. Other rounds of the same group
    // do not count: they use the same resources, but do not read the content of this round.
    static std::vector<uint8_t> find_read_outside(const FramePlan& plan) {
        const ResolvedGraph& graph = plan.graph;
        std::vector<uint32_t> writer(graph.resources.size(), kNoId);
        for (const PassId pass : plan.schedule.order)
            for (const UseDecl& use : graph.passes[pass].uses)
                if (writes(use.access)) writer[use.resource] = graph.passes[pass].rest_unit;
        const auto together = [&](uint32_t a, uint32_t b) {
            return a == b ||
                   (find_group(graph, a) != nullptr && find_group(graph, a) == find_group(graph, b));
        };
        std::vector<uint8_t> found(graph.resources.size(), 0);
        for (const PassId pass : plan.schedule.order)
            for (const UseDecl& use : graph.passes[pass].uses)
                if (!together(writer[use.resource], graph.passes[pass].rest_unit)) found[use.resource] = 1;
        return found;
    }

    [[nodiscard]] bool is_same(PassId pass, uint32_t old_unit) const {
        const PassId old = find_pass(old_.graph, new_.graph.passes[pass].name);
        if (old == kNoId || old_.graph.passes[old].rest_unit != old_unit) return false;
        const Position at = new_.schedule.position[pass], old_at = old_.schedule.position[old];
        return old_at != kNoId && declaration_hash(old_, old) == declaration_hash(new_, pass) &&
               same_pipelines_(old_at, at);
    }

    // Returns true if the new plan has all results of the pass that a pass outside the unit may read.
    [[nodiscard]] bool keeps_results(PassId pass) const {
        return std::ranges::all_of(new_.graph.passes[pass].uses, [&](const UseDecl& use) {
            if (!writes(use.access)) return true;
            if (new_.graph.resources[use.resource].lifetime == ResourceLifetime::transient)
                return read_outside_[use.resource] == 0;
            return std::ranges::any_of(transition_.carried, [&](const ContentCopy& copy) {
                return copy.to == use.resource && !copy.resample;
            });
        });
    }

    const FramePlan& old_;
    const FramePlan& new_;
    const TransitionPlan& transition_;
    const SamePipelines& same_pipelines_;
    std::vector<std::vector<PassId>> old_passes_, new_passes_;  // Index: unit.
    std::vector<uint8_t> read_outside_;                         // Index: ResourceId of the new plan.
};

}  // namespace

std::vector<MatchedUnit> match_units(const FramePlan& old_plan, const FramePlan& new_plan,
                                     const TransitionPlan& transition, const SamePipelines& same_pipelines) {
    const UnitMatch match(old_plan, new_plan, transition, same_pipelines);
    std::vector<MatchedUnit> units;
    for (uint32_t unit = 0; unit < new_plan.graph.rest_unit_count; ++unit) units.push_back(match.match(unit));
    return units;
}

}  // namespace weft
