#include "tests/vulkan/make_ring.h"

#include <cassert>

namespace weft::test {
namespace {

ResourceId role_of(const ResolvedGraph& graph, const std::string& name, uint32_t age) {
    const ResourceId id = find_resource(graph, age == 0 ? name : name + "[-" + std::to_string(age) + "]");
    assert(id != kNoId);
    return id;
}

}  // namespace

void make_ring(ResolvedGraph& graph, const std::string& name, uint32_t history,
               const std::array<float, 4>& first_frame) {
    UsageMask usage = 0;
    for (uint32_t age = 0; age <= history; ++age) usage |= graph.resources[role_of(graph, name, age)].usage;
    for (uint32_t age = 0; age <= history; ++age) {
        ResourceDecl& role = graph.resources[role_of(graph, name, age)];
        role.lifetime = ResourceLifetime::persistent;
        role.usage = usage;
        role.history = history;
        role.ring = role_of(graph, name, 0);
        role.age = age;
        role.first_frame = first_frame;
    }
    for (PassDecl& pass : graph.passes)
        for (UseDecl& use : pass.uses)
            if (graph.resources[use.resource].ring == role_of(graph, name, 0))
                use.history = graph.resources[use.resource].age;
}

}  // namespace weft::test
