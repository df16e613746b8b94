#include "weft/declaration.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "graph/diagnostics/name_of_value.h"
#include "graph/model/access_table.h"
#include "weft/imports.h"
#include "weft/pass.h"

namespace weft {
namespace {

bool spans_overlap(uint32_t a, uint32_t a_count, uint32_t b, uint32_t b_count) {
    return a < b + b_count && b < a + a_count;
}

template <class Index, class T>
Index find_by_name(const std::vector<T>& sorted, std::string_view name) {
    const auto it = std::lower_bound(sorted.begin(), sorted.end(), name,
                                     [](const T& item, std::string_view n) { return item.name < n; });
    return it != sorted.end() && it->name == name ? Index(it - sorted.begin()) : Index(kNoId);
}

}  // namespace

bool overlaps(const SubresourceRange& a, const SubresourceRange& b) {
    return (a.aspects & b.aspects) != 0 && spans_overlap(a.mip, a.mips, b.mip, b.mips) &&
           spans_overlap(a.layer, a.layers, b.layer, b.layers);
}

bool contains(const SubresourceRange& outer, const SubresourceRange& inner) {
    return (inner.aspects & ~outer.aspects) == 0 && outer.mip <= inner.mip &&
           inner.mip + inner.mips <= outer.mip + outer.mips && outer.layer <= inner.layer &&
           inner.layer + inner.layers <= outer.layer + outer.layers;
}

uint32_t element_count(const UseDecl& use) {
    switch (use.each) {
        case EachPart::none:
            break;
        case EachPart::mip:
            return use.range.mips;
        case EachPart::layer:
            return use.range.layers;
    }
    return 1;
}

SubresourceRange element_range(const UseDecl& use, uint32_t element) {
    SubresourceRange range = use.range;
    if (use.each == EachPart::none) return range;
    const uint32_t step = std::min(element, element_count(use) - 1);
    if (use.each == EachPart::mip) {
        range.mip += step;
        range.mips = 1;
    } else {
        range.layer += step;
        range.layers = 1;
    }
    return range;
}

std::string range_text(const ResourceDecl& resource, const SubresourceRange& range) {
    const auto span = [](const char* what, uint64_t first, uint64_t count) {
        std::string text = std::string(".") + what + "(" + std::to_string(first);
        if (count > 1) text += ".." + std::to_string(first + count - 1);
        return text + ")";
    };
    if (resource.kind == ResourceKind::buffer) {
        if (resource.cuts_bytes.empty()) return {};
        const ByteRange bytes = piece_bytes(resource, range);
        const uint64_t stride = std::max(1u, resource.stride_bytes);
        return span("range", bytes.offset_bytes / stride, (bytes.size_bytes + stride - 1) / stride);
    }
    if (resource.textures > 0) return {};
    return span("mip", range.mip, range.mips) + span("layer", range.layer, range.layers);
}

UsageMask usage_of(Access a) {
    return access_row(a).usage;
}

SubresourceRange ResourceDecl::whole() const {
    if (kind == ResourceKind::buffer)
        return {0, 1, 0, static_cast<uint32_t>(cuts_bytes.size()) + 1, aspect::kColor};
    return {0, mips, 0, layers, aspects};
}

ByteRange piece_bytes(const ResourceDecl& buffer, const SubresourceRange& range) {
    const auto start = [&](uint64_t piece) {
        if (piece == 0) return uint64_t{0};
        return piece <= buffer.cuts_bytes.size() ? buffer.cuts_bytes[piece - 1] : buffer.size_bytes;
    };
    const uint64_t first = start(range.layer);
    return {first, start(uint64_t{range.layer} + range.layers) - first};
}

ByteRange used_bytes(const ResourceDecl& buffer, const UseDecl& use) {
    return use.bytes.value_or(ByteRange{0, buffer.size_bytes});
}

AccessState clear_state(const ResourceDecl& resource) {
    const bool image = resource.kind == ResourceKind::image;
    return access_state(Access::clear_write, 0, image ? resource.aspects : aspect::kNone);
}

Extent3D mip_extent(const Extent3D& extent, uint32_t mip) {
    const auto halved = [mip](uint32_t side) { return std::max(1u, mip < 32 ? side >> mip : 0u); };
    return {halved(extent.width), halved(extent.height), halved(extent.depth)};
}

uint64_t content_bytes(const ResourceDecl& resource) {
    if (resource.kind == ResourceKind::buffer) return resource.size_bytes;
    uint64_t texels = 0;
    for (uint32_t mip = 0; mip < resource.mips; ++mip) {
        const Extent3D e = mip_extent(resource.extent, mip);
        texels += uint64_t{e.width} * e.height * e.depth;
    }
    return texels * resource.layers * resource.samples * format_info(resource.format).bytes_per_texel;
}

const GroupDecl* find_group(const ResolvedGraph& graph, uint32_t unit) {
    if (unit == kNoId) return nullptr;
    for (const GroupDecl& group : graph.groups)
        if (group.has_unit(unit)) return &group;
    return nullptr;
}

ResourceId find_resource(const ResolvedGraph& graph, std::string_view name) {
    return find_by_name<ResourceId>(graph.resources, name);
}

PassId find_pass(const ResolvedGraph& graph, std::string_view name) {
    return find_by_name<PassId>(graph.passes, name);
}

bool runs_in_frame(const PassDecl& pass, uint64_t frame) {
    return pass.frame_slices == 0 || frame == 0 || frame % pass.frame_slices == pass.frame_slice;
}

const char* import_kind_name(ImportKind kind) {
    return name_of_value(kind,
                         std::array{"drawlist", "buffer", "image", "cube", "output", "views", "textures"});
}

AccessState texture_table_state() {
    return {stage::kVertexShader | stage::kFragmentShader | stage::kComputeShader, access::kSampledRead,
            Layout::shader_read_only};
}

ImportDecl texture_table(const std::string& name, uint32_t count) {
    ImportDecl import;
    import.name = name;
    import.kind = ImportKind::textures;
    import.read_only = true;
    ResourceDecl& table = import.resource;
    table.name = name;
    table.kind = ResourceKind::image;
    table.lifetime = ResourceLifetime::imported;
    table.format = Format::rgba8;
    table.usage = usage::kSampled;
    table.textures = std::max(1u, count);
    table.import = ImportState{texture_table_state(), texture_table_state(), 0, true};
    return import;
}

double PassContext::param(std::string_view name) const {
    const auto it =
        std::find_if(params.begin(), params.end(), [name](const NamedValue& v) { return v.name == name; });
    assert(it != params.end() && "the pass type declares no such parameter");
    return it->value;
}

}  // namespace weft
