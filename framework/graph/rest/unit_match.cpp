#include "graph/rest/unit_match.h"

#include <algorithm>
#include <string>
#include <utility>

#include "graph/plan/field_hash.h"

namespace weft {
namespace {

// Returns a hash of everything in the declaration of a pass on which its result depends, except the values of
// its Params. Resources and passes are named, because their ids differ between plans.
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
            v("port", use.port), v("range", use.range), v("access", use.access), v("sampler", use.sampler),
                v("wakes", use.wakes);
            v("name", resource.name), v("kind", resource.kind), v("imageKind", resource.image_kind);
            v("format", resource.format), v("extent", resource.extent), v("mips", resource.mips);
            v("layers", resource.layers), v("samples", resource.samples), v("bytes", resource.size_bytes);
            for (const VersionSource& source : use.sources) {
                v("range", source.range);
                v("producer",
                  source.producer == kNoId ? std::string() : plan.graph.passes[source.producer].name);
            }
        }
    });
}

class UnitMatch {
 public:
    UnitMatch(const FramePlan& old_plan, const FramePlan& new_plan, const TransitionPlan& transition,
              const SamePipelines& same_pipelines)
        : old_(old_plan), new_(new_plan), transition_(transition), same_pipelines_(same_pipelines) {}

    // Returns the unit of the old plan that computes the same as `unit` of the new plan, or kNoId.
    [[nodiscard]] uint32_t old_unit(uint32_t unit) const {
        const std::vector<PassId> passes = passes_of(new_, unit);
        if (passes.empty()) return kNoId;
        const PassId first = find_pass(old_.graph, new_.graph.passes[passes.front()].name);
        if (first == kNoId) return kNoId;
        const uint32_t old_unit = old_.graph.passes[first].rest_unit;
        if (old_unit == kNoId || passes_of(old_, old_unit).size() != passes.size()) return kNoId;
        const bool same = std::ranges::all_of(
            passes, [&](PassId pass) { return is_same(pass, old_unit) && keeps_results(pass, unit); });
        return same ? old_unit : uint32_t{kNoId};
    }

 private:
    static std::vector<PassId> passes_of(const FramePlan& plan, uint32_t unit) {
        std::vector<PassId> passes;
        for (const PassId pass : plan.schedule.order)
            if (plan.graph.passes[pass].rest_unit == unit) passes.push_back(pass);
        return passes;
    }

    [[nodiscard]] bool is_same(PassId pass, uint32_t old_unit) const {
        const PassId old = find_pass(old_.graph, new_.graph.passes[pass].name);
        if (old == kNoId || old_.graph.passes[old].rest_unit != old_unit) return false;
        const Position at = new_.schedule.position[pass], old_at = old_.schedule.position[old];
        return old_at != kNoId && declaration_hash(old_, old) == declaration_hash(new_, pass) &&
               same_pipelines_(old_at, at);
    }

    // Returns true if the new plan has all results of the pass that a pass outside the unit may read.
    [[nodiscard]] bool keeps_results(PassId pass, uint32_t unit) const {
        return std::ranges::all_of(new_.graph.passes[pass].uses, [&](const UseDecl& use) {
            if (!writes(use.access)) return true;
            if (new_.graph.resources[use.resource].lifetime == ResourceLifetime::transient)
                return !is_read_outside(use.resource, unit);
            return std::ranges::any_of(transition_.carried, [&](const ContentCopy& copy) {
                return copy.to == use.resource && !copy.resample;
            });
        });
    }

    [[nodiscard]] bool is_read_outside(ResourceId resource, uint32_t unit) const {
        return std::ranges::any_of(new_.schedule.order, [&](PassId pass) {
            const PassDecl& decl = new_.graph.passes[pass];
            return decl.rest_unit != unit && std::ranges::any_of(decl.uses, [&](const UseDecl& use) {
                       return use.resource == resource;
                   });
        });
    }

    const FramePlan& old_;
    const FramePlan& new_;
    const TransitionPlan& transition_;
    const SamePipelines& same_pipelines_;
};

}  // namespace

std::vector<uint32_t> match_units(const FramePlan& old_plan, const FramePlan& new_plan,
                                  const TransitionPlan& transition, const SamePipelines& same_pipelines) {
    const UnitMatch match(old_plan, new_plan, transition, same_pipelines);
    std::vector<uint32_t> units;
    for (uint32_t unit = 0; unit < new_plan.graph.rest_unit_count; ++unit)
        units.push_back(match.old_unit(unit));
    return units;
}

}  // namespace weft
