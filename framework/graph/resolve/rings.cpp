#include "graph/resolve/rings.h"

#include <utility>

namespace weft {

std::string role_name(const std::string& name, uint32_t age) {
    return age == 0 ? name : name + "[-" + std::to_string(age) + "]";
}

void spread_over_rings(std::vector<ResourceDecl>& resources, Suspects& suspects) {
    for (ResourceId id(0); id < resources.size(); ++id) {
        ResourceDecl& role = resources[id];
        if (role.age == 0) continue;
        std::string name = std::move(role.name);
        const uint32_t age = role.age;
        const ResourceId ring = role.ring;
        role = resources[ring];
        role.name = std::move(name);
        role.age = age;
        suspects.shapes[id] = suspects.shapes[ring];
    }
}

}  // namespace weft
