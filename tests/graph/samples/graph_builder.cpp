#include "tests/graph/samples/graph_builder.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <numeric>
#include <tuple>

namespace weft::test {
namespace {

bool is_color(Access a) {
    return a == Access::color_write || a == Access::color_read_write;
}
bool is_depth(Access a) {
    return a == Access::depth_write || a == Access::depth_read_write || a == Access::depth_read;
}

// State of one mip level of one array layer: the pass that wrote it last, and the passes that have read it
// since then.
struct CellVersion {
    PassId writer = kNoId;
    std::vector<PassId> readers;
};

// Finds, for each read, the passes that wrote the content. Also adds the edges between passes. The caller
// must call add() for each pass, in program order.
class Versions {
 public:
    explicit Versions(ResolvedGraph& graph) : graph_(graph), cells_(graph.resources.size()) {
        for (size_t r = 0; r < cells_.size(); ++r)
            cells_[r].resize(size_t{graph.resources[r].whole().mips} * graph.resources[r].whole().layers);
    }

    void add(PassId pass) {
        for (UseDecl& use : graph_.passes[pass].uses)
            if (reads(use.access)) read(pass, use);
        for (UseDecl& use : graph_.passes[pass].uses)
            if (writes(use.access)) write(pass, use);
    }

 private:
    template <class F>
    void for_cells(const UseDecl& use, F visit) {
        for (uint32_t layer = use.range.layer; layer < use.range.layer + use.range.layers; ++layer)
            for (uint32_t mip = use.range.mip; mip < use.range.mip + use.range.mips; ++mip)
                visit(cells_[use.resource][layer * graph_.resources[use.resource].mips + mip], mip, layer);
    }

    void read(PassId pass, UseDecl& use) {
        for_cells(use, [&](CellVersion& cell, uint32_t mip, uint32_t layer) {
            cell.readers.push_back(pass);
            use.sources.push_back({{mip, 1, layer, 1, use.range.aspects}, cell.writer});
            if (cell.writer != kNoId) edge(cell.writer, pass, EdgeKind::raw, use);
        });
        const bool same = std::all_of(use.sources.begin(), use.sources.end(), [&](const VersionSource& s) {
            return s.producer == use.sources.front().producer;
        });
        if (same) use.sources = {{use.range, use.sources.front().producer}};
    }

    void write(PassId pass, const UseDecl& use) {
        for_cells(use, [&](CellVersion& cell, uint32_t, uint32_t) {
            if (cell.writer != kNoId) edge(cell.writer, pass, EdgeKind::waw, use);
            for (const PassId reader : cell.readers) edge(reader, pass, EdgeKind::war, use);
            cell = {pass, {}};
        });
    }

    void edge(PassId from, PassId to, EdgeKind kind, const UseDecl& use) {
        if (from != to) graph_.edges.push_back({from, to, kind, use.resource, {}});
    }

    ResolvedGraph& graph_;
    // One CellVersion for each mip level of each array layer: cells_[resource][layer * mips + mip].
    std::vector<std::vector<CellVersion>> cells_;
};

template <class Index, class T>
std::vector<Index> sort_by_name(std::vector<T>& items) {
    std::vector<Index> order(items.size()), new_id(items.size());
    std::iota(order.begin(), order.end(), Index(0u));
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return items[a].name < items[b].name; });
    std::vector<T> sorted;
    for (Index i(0); i < order.size(); ++i) {
        new_id[order[i]] = i;
        sorted.push_back(items[order[i]]);
    }
    items = std::move(sorted);
    return new_id;
}

void sort_everything(ResolvedGraph& graph) {
    const std::vector<PassId> passes = sort_by_name<PassId>(graph.passes);
    const std::vector<ResourceId> resources = sort_by_name<ResourceId>(graph.resources);
    for (ResourceDecl& resource : graph.resources)
        if (resource.ring != kNoId) resource.ring = resources[resource.ring];
    for (PassDecl& pass : graph.passes) {
        for (UseDecl& use : pass.uses) {
            use.resource = resources[use.resource];
            for (VersionSource& source : use.sources)
                if (source.producer != kNoId) source.producer = passes[source.producer];
        }
        for (ParamWrite& param : pass.params)
            if (param.resource != kNoId) param.resource = resources[param.resource];
    }
    for (EdgeDecl& edge : graph.edges) {
        edge.from = passes[edge.from];
        edge.to = passes[edge.to];
        if (edge.resource != kNoId) edge.resource = resources[edge.resource];
    }
    if (graph.output != kNoId) graph.output = resources[graph.output];
    const auto key = [](const EdgeDecl& e) { return std::make_tuple(e.to, e.from, e.kind, e.resource); };
    std::sort(graph.edges.begin(), graph.edges.end(),
              [&](const EdgeDecl& a, const EdgeDecl& b) { return key(a) < key(b); });
    graph.edges.erase(std::unique(graph.edges.begin(), graph.edges.end(),
                                  [&](const EdgeDecl& a, const EdgeDecl& b) { return key(a) == key(b); }),
                      graph.edges.end());
}

const char* type_name(PassKind kind) {
    constexpr const char* kNames[] = {"compute", "fullscreen", "raster", "clear",
                                      "copy",    "readback",   "custom", "blit"};
    return kNames[static_cast<size_t>(kind)];
}

void add_attachments(const ResolvedGraph& graph, PassDecl& pass) {
    for (uint32_t u = 0; u < pass.uses.size(); ++u) {
        const UseDecl& use = pass.uses[u];
        if (!is_color(use.access) && !is_depth(use.access)) continue;
        AttachmentDecl attachment;
        attachment.use = u;
        attachment.location = static_cast<uint32_t>(pass.colors.size());
        pass.render_extent = mip_extent(graph.resources[use.resource].extent, use.range.mip);
        if (is_color(use.access))
            pass.colors.push_back(attachment);
        else
            pass.depth = attachment;
    }
}

}  // namespace

SubresourceRange one_cell(uint32_t mip, uint32_t layer) {
    return {mip, 1, layer, 1, aspect::kColor};
}

ResourceId GraphBuilder::image(std::string name, Format format, uint32_t side_px, uint32_t mips,
                               uint32_t layers) {
    ResourceDecl decl;
    decl.name = std::move(name);
    decl.format = format;
    decl.extent = {side_px, side_px, 1};
    decl.mips = mips;
    decl.layers = layers;
    decl.image_kind = layers > 1 ? ImageKind::d2_array : ImageKind::d2;
    decl.aspects = format_info(format).depth ? aspect::kDepth : aspect::kColor;
    graph_.resources.push_back(decl);
    return static_cast<ResourceId>(graph_.resources.size() - 1);
}

ResourceId GraphBuilder::buffer(std::string name, uint64_t size_bytes) {
    ResourceDecl decl;
    decl.name = std::move(name);
    decl.kind = ResourceKind::buffer;
    decl.size_bytes = size_bytes;
    decl.stride_bytes = 4;
    graph_.resources.push_back(decl);
    return static_cast<ResourceId>(graph_.resources.size() - 1);
}

void GraphBuilder::import_as(ResourceId resource, const AccessState& entry, const AccessState& exit) {
    graph_.resources[resource].lifetime = ResourceLifetime::imported;
    graph_.resources[resource].import = ImportState{entry, exit, 0};
}

void GraphBuilder::make_concurrent(ResourceId import) {
    graph_.resources[import].import->concurrent = true;
}

std::vector<ResourceId> GraphBuilder::ring(ResourceId resource, uint32_t history) {
    ResourceDecl& newest = graph_.resources[resource];
    newest.lifetime = ResourceLifetime::persistent;
    newest.history = history;
    newest.ring = resource;
    newest.usage |= usage::kTransferDst;
    std::vector<ResourceId> roles{resource};
    const ResourceDecl decl = newest;
    for (uint32_t age = 1; age <= history; ++age) {
        roles.push_back(static_cast<ResourceId>(graph_.resources.size()));
        graph_.resources.push_back(decl);
        graph_.resources.back().name += "[-" + std::to_string(age) + "]";
        graph_.resources.back().age = age;
    }
    return roles;
}

PassDecl& GraphBuilder::pass(std::string name, PassKind kind, const std::vector<BuilderUse>& uses) {
    PassDecl decl;
    decl.name = std::move(name);
    decl.type = type_name(kind);
    decl.kind = kind;
    decl.side_effect = kind == PassKind::readback;
    decl.order_key = static_cast<uint32_t>(graph_.passes.size());
    if (kind == PassKind::compute) decl.groups = {1, 1, 1};
    const ShaderStageMask shaders =
        stage_bit(kind == PassKind::compute ? ShaderStage::compute : ShaderStage::fragment);
    for (const BuilderUse& u : uses) {
        ResourceDecl& resource = graph_.resources[u.resource];
        const bool image = resource.kind == ResourceKind::image;
        UseDecl use;
        use.port = u.port;
        use.resource = u.resource;
        use.range = u.range.value_or(resource.whole());
        if (!image && use.range != resource.whole()) use.bytes = piece_bytes(resource, use.range);
        use.access = u.access;
        use.state = access_state(u.access, shaders, image ? resource.aspects : aspect::kNone);
        use.is_output = writes(u.access);
        use.binding = u.binding;
        use.sampler.filter = SamplerFilter::nearest;
        use.sampler.mip_filter = SamplerFilter::nearest;
        use.history = resource.age;
        resource.usage |= usage_of(u.access);
        decl.uses.push_back(use);
    }
    add_attachments(graph_, decl);
    graph_.passes.push_back(decl);
    return graph_.passes.back();
}

void GraphBuilder::after(const std::string& from, const std::string& to) {
    after_.emplace_back(from, to);
}

ResolvedGraph GraphBuilder::build() const {
    ResolvedGraph graph = graph_;
    if (graph.name.empty()) graph.name = "built";
    // The resources of a ring exchange their memory from frame to frame: "x" becomes "x[-1]", and so on. So
    // each resource of a ring needs the usage flags of all of them.
    for (const ResourceDecl& role : graph_.resources)
        if (role.ring != kNoId) graph.resources[role.ring].usage |= role.usage;
    for (ResourceDecl& role : graph.resources)
        if (role.ring != kNoId) role.usage = graph.resources[role.ring].usage;
    std::map<std::string, PassId> ids;
    Versions versions(graph);
    for (PassId pass(0); pass < graph.passes.size(); ++pass) {
        ids.emplace(graph.passes[pass].name, pass);
        versions.add(pass);
    }
    assert(ids.size() == graph.passes.size() && "names are unique");
    for (const auto& [from, to] : after_)
        graph.edges.push_back({ids.at(from), ids.at(to), EdgeKind::after, kNoId, {}});
    sort_everything(graph);
    return graph;
}

}  // namespace weft::test
