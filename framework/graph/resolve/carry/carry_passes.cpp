#include "graph/resolve/carry/carry_passes.h"

#include <algorithm>
#include <vector>

#include "graph/resolve/rings.h"

namespace weft {
namespace {

RefDesc reference(const ResourceDesc& resource, uint32_t age) {
    RefDesc ref;
    ref.name = resource.name;
    ref.history = age;
    ref.text = role_name(resource.name, age);
    ref.loc = resource.loc;
    return ref;
}

PortDesc port(std::string name, const ResourceDesc& resource, uint32_t age) {
    PortDesc port;
    port.port = std::move(name);
    port.ref = reference(resource, age);
    port.loc = resource.loc;
    return port;
}

// The parts (a mip of a layer) of one resource for which the content of the last frame is needed.
class NeededParts {
 public:
    NeededParts(const ResolvedGraph& graph, PassId carry)
        : whole_(graph.resources[graph.passes[carry].uses.back().resource].whole()),
          written_(size_t{whole_.mips} * whole_.layers, 0),
          needed_(written_.size(), 0) {
        const ResourceId resource = graph.passes[carry].uses.back().resource;
        for (PassId id(0); id < graph.passes.size(); ++id) {
            if (id == carry) continue;
            for (const UseDecl& use : graph.passes[id].uses) {
                if (use.resource != resource) continue;
                if (writes(use.access)) note_write(use.range);
                for (const std::vector<VersionSource>* versions : {&use.sources, &use.passes_on})
                    for (const VersionSource& source : *versions)
                        if (source.producer == carry) mark(source.range, needed_, whole_.aspects);
            }
        }
    }

    // Returns the smallest range that contains all needed parts. A part is needed if a pass sees its old
    // content, or if the other passes do not write all aspects of it. If no part is needed, the range has no
    // mips.
    [[nodiscard]] SubresourceRange box() const {
        SubresourceRange box = whole_;
        uint32_t mip_end = 0, layer_end = 0;
        box.mip = whole_.mips;
        box.layer = whole_.layers;
        for (uint32_t layer = 0; layer < whole_.layers; ++layer)
            for (uint32_t mip = 0; mip < whole_.mips; ++mip) {
                const size_t at = index(mip, layer);
                if (!needed_[at] && written_[at] == whole_.aspects) continue;
                box.mip = std::min(box.mip, mip);
                box.layer = std::min(box.layer, layer);
                mip_end = std::max(mip_end, mip + 1);
                layer_end = std::max(layer_end, layer + 1);
            }
        box.mips = mip_end > box.mip ? mip_end - box.mip : 0;
        box.layers = layer_end > box.layer ? layer_end - box.layer : 0;
        return box;
    }

 private:
    [[nodiscard]] size_t index(uint32_t mip, uint32_t layer) const {
        return size_t{layer} * whole_.mips + mip;
    }

    void note_write(const SubresourceRange& range) { mark(range, written_, range.aspects); }

    void mark(const SubresourceRange& range, std::vector<AspectMask>& parts, AspectMask aspects) const {
        for (uint32_t layer = range.layer; layer < range.layer + range.layers; ++layer)
            for (uint32_t mip = range.mip; mip < range.mip + range.mips; ++mip)
                parts[index(mip, layer)] |= aspects;
    }

    SubresourceRange whole_;
    // The aspects that other passes write, for each part. The index is computed by index(): layer by layer,
    // and within a layer mip by mip.
    std::vector<AspectMask> written_;
    // The aspects whose content of the last frame a pass sees, with the same index. 0: no pass sees that
    // content.
    std::vector<AspectMask> needed_;
};

// Gives the passes new ids after some of them were removed. `removed` has one entry for each old id.
void renumber(const std::vector<uint8_t>& removed, ResolvedGraph& graph) {
    std::vector<PassId> ids(removed.size(), kNoId);
    PassId next(0);
    for (PassId id(0); id < removed.size(); ++id)
        if (!removed[id]) {
            ids[id] = next;
            ++next;
        }
    std::vector<PassDecl> passes;
    for (PassId id(0); id < removed.size(); ++id)
        if (!removed[id]) passes.push_back(std::move(graph.passes[id]));
    graph.passes = std::move(passes);
    for (PassDecl& pass : graph.passes)
        for (UseDecl& use : pass.uses)
            for (std::vector<VersionSource>* versions : {&use.sources, &use.passes_on})
                for (VersionSource& source : *versions)
                    if (source.producer != kNoId) source.producer = ids[source.producer];
    std::erase_if(graph.edges, [&](const EdgeDecl& e) { return removed[e.from] || removed[e.to]; });
    for (EdgeDecl& edge : graph.edges)
        edge = {ids[edge.from], ids[edge.to], edge.kind, edge.resource, edge.loc};
}

}  // namespace

std::map<std::string, PassDesc> describe_carries(const ResolveInput& input, const Shapes& shapes) {
    std::map<std::string, PassDesc> carries;
    for (const auto& [name, resource] : input.graph.resources) {
        if (resource.keep == KeepMode::none || !shapes.histories.contains(name)) continue;
        PassDesc desc;
        desc.name = "carry:" + name;
        desc.type = "copy";
        desc.in.push_back(port("src", resource, 1));
        desc.out.push_back(port("dst", resource, 0));
        desc.loc = resource.loc;
        carries.emplace(desc.name, std::move(desc));
    }
    return carries;
}

ResolvedGraph remove_idle_carries(ResolvedGraph graph) {
    std::vector<uint8_t> removed(graph.passes.size(), 0);
    bool any = false;
    for (PassId id(0); id < graph.passes.size(); ++id) {
        PassDecl& pass = graph.passes[id];
        if (!pass.carries || pass.uses.size() != 2) continue;
        const SubresourceRange box = NeededParts(graph, id).box();
        removed[id] = box.mips == 0 ? 1 : 0;
        any |= removed[id] != 0;
        const ResourceDecl& resource = graph.resources[pass.uses.back().resource];
        for (UseDecl& use : pass.uses) {
            use.range = box;
            if (resource.kind == ResourceKind::buffer && !removed[id] && box != resource.whole())
                use.bytes = piece_bytes(resource, box);
            for (VersionSource& source : use.sources) source.range = box;
        }
    }
    if (any) renumber(removed, graph);
    return graph;
}

}  // namespace weft
