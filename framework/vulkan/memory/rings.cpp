#include "vulkan/memory/rings.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace weft::vk {

Rings::Rings(const FramePlan& plan) {
    const std::vector<ResourceDecl>& resources = plan.graph.resources;
    all_.resize(resources.size());
    roles_.resize(resources.size());
    written_.resize(resources.size());
    inherited_.resize(resources.size());
    for (ResourceId id(0); id < resources.size(); ++id) {
        const ResourceDecl& decl = resources[id];
        if (decl.ring == kNoId) continue;
        all_[id] = {decl.ring, decl.age};
        std::vector<ResourceId>& roles = roles_[decl.ring];
        roles.resize(decl.history + 1, kNoId);
        assert(decl.age < roles.size());
        roles[decl.age] = id;
    }
    for (const PassId pass : plan.schedule.order)
        for (const UseDecl& use : plan.graph.passes[pass].uses)
            if (writes(use.access) && !plan.graph.passes[pass].carries) written_[use.resource] = 1;
}

ResourceId Rings::copy(ResourceId resource, uint64_t frame) const {
    const Role& role = all_[resource];
    if (role.ring == kNoId) return resource;
    const std::vector<ResourceId>& roles = roles_[role.ring];
    return roles[(frame + roles.size() - role.age) % roles.size()];
}

std::vector<ResourceId> Rings::roles(ResourceId resource) const {
    if (all_[resource].ring == kNoId) return {resource};
    return roles_[all_[resource].ring];
}

uint64_t Rings::period(const PassDecl& pass) const {
    uint64_t period = 1;
    for (const UseDecl& use : pass.uses)
        if (all_[use.resource].ring != kNoId)
            period = std::lcm(period, uint64_t{roles_[all_[use.resource].ring].size()});
    return period;
}

void Rings::inherit(const Rings& old, uint64_t frames, const TransitionPlan& transition) {
    for (const ContentCopy& carry : transition.carried) {
        const ResourceId ring = all_[carry.to].ring, old_ring = old.all_[carry.from].ring;
        if (transition.keeps_validity[ring] == 0) continue;
        if (old.written_[old_ring] == 0 && old.inherited_[old_ring] == 0) continue;
        // An old ring of N + 1 copies has the contents of at most N past frames. A ring of one copy has the
        // content of the last frame. If the new history is longer, its older frames are not valid yet.
        inherited_[ring] = std::min<uint64_t>(frames + old.inherited_[old_ring],
                                              std::max<uint64_t>(old.roles_[old_ring].size() - 1, 1));
    }
}

bool Rings::valid(ResourceId role, uint64_t frame) const {
    const ResourceId ring = all_[role].ring;
    if (ring == kNoId) return false;
    // If no pass of this plan writes the ring, the ring can still have the contents that it took over from an
    // old plan (`keep`).
    const bool has_content = written_[ring] != 0 || inherited_[ring] != 0;
    return has_content && frame + inherited_[ring] >= all_[role].age;
}

}  // namespace weft::vk
