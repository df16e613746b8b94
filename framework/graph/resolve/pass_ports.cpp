#include "graph/resolve/pass_ports.h"

namespace weft {

std::vector<const PortDesc*> written_ports(const PassDesc& desc) {
    std::vector<const PortDesc*> ports;
    for (const PortDesc& port : desc.out) ports.push_back(&port);
    if (desc.depth) ports.push_back(&*desc.depth);
    for (const ResolveDesc& resolve : desc.resolves) ports.push_back(&resolve.target);
    return ports;
}

bool names_this_frames(const PortDesc& port, const std::string& resource) {
    return port.ref.name == resource && port.ref.history == 0;
}

const PortDesc* output_of(const PassDesc& desc, const std::string& resource) {
    for (const PortDesc* port : written_ports(desc)) {
        if (names_this_frames(*port, resource)) return port;
    }
    return nullptr;
}

BlendState blend_of(const PassDesc& desc, const std::string& port) {
    const auto own = desc.blend.find(port);
    if (own != desc.blend.end()) return own->second;
    const auto all = desc.blend.find("");
    return all != desc.blend.end() ? all->second : BlendState{};
}

bool has_shader(PassKind kind) {
    return kind == PassKind::compute || kind == PassKind::fullscreen || kind == PassKind::raster;
}

Extent3D use_extent(const std::vector<ResourceDecl>& resources, const UseDecl& use) {
    return mip_extent(resources[use.resource].extent, use.range.mip);
}

}  // namespace weft
