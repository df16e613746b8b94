#include "graph/resolve/check/check_copy.h"

#include <optional>

#include "graph/resolve/fault_text.h"
#include "graph/resolve/pass_ports.h"

namespace weft {
namespace {

std::string shape_text(const std::vector<ResourceDecl>& resources, const UseDecl& use) {
    const ResourceDecl& resource = resources[use.resource];
    if (resource.kind == ResourceKind::buffer)
        return std::to_string(used_bytes(resource, use).size_bytes) + " bytes";
    return extent_text(use_extent(resources, use)) + ", " + std::to_string(use.range.mips) + " mips, " +
           std::to_string(use.range.layers) + " layers, " + std::string(format_info(resource.format).name);
}

bool same_shape(const std::vector<ResourceDecl>& resources, const UseDecl& a, const UseDecl& b) {
    const ResourceDecl& from = resources[a.resource];
    const ResourceDecl& to = resources[b.resource];
    if (from.kind != to.kind) return false;
    if (from.kind == ResourceKind::buffer)
        return used_bytes(from, a).size_bytes == used_bytes(to, b).size_bytes;
    const FormatInfo& f = format_info(from.format);
    const FormatInfo& t = format_info(to.format);
    const bool formats =
        from.format == to.format || (f.bytes_per_texel == t.bytes_per_texel && !f.depth && !t.depth);
    return formats && use_extent(resources, a) == use_extent(resources, b) && a.range.mips == b.range.mips &&
           a.range.layers == b.range.layers && a.range.aspects == b.range.aspects &&
           from.samples == to.samples;
}

// Returns true if the sampler has a setting that a blit cannot use. A blit uses only the filter of a sampler.
bool only_shaders_can_use(const SamplerDecl& sampler) {
    SamplerDecl plain = sampler;
    plain.filter = plain.mip_filter = SamplerFilter::linear;
    plain.wrap = SamplerWrap::clamp;
    return plain != SamplerDecl{};
}

struct BlitFault {
    std::string reason;
    std::string remedy;
};

// Returns why an image cannot be blitted to another image, or nullopt if a blit is possible.
std::optional<BlitFault> blit_fault(const std::vector<ResourceDecl>& resources, const UseDecl& from,
                                    const UseDecl& to) {
    const ResourceDecl& source = resources[from.resource];
    const ResourceDecl& target = resources[to.resource];
    if (source.kind == ResourceKind::buffer || target.kind == ResourceKind::buffer)
        return BlitFault{"a buffer cannot be blitted", "set \"type\": \"copy\" to copy a buffer"};
    if (source.samples > 1 || target.samples > 1)
        return BlitFault{"multisampled images can only be resolved, not blitted",
                         "resolve the image in a raster pass, or read its samples in a fullscreen pass"};
    const NumericClass numeric = format_info(source.format).numeric;
    if (numeric != format_info(target.format).numeric)
        return BlitFault{"their formats have different numeric types",
                         "use a fullscreen pass, whose shader converts the values"};
    if (numeric == NumericClass::depth && source.format != target.format)
        return BlitFault{"depth images need the same format",
                         "give both the same format, or use a fullscreen pass"};
    const bool linear = from.sampler.filter == SamplerFilter::linear;
    if (linear && numeric != NumericClass::float_like)
        return BlitFault{"linear filtering needs a format of floats",
                         "set \"sampler\": { \"filter\": \"nearest\" } for the input"};
    if (only_shaders_can_use(from.sampler))
        return BlitFault{"the sampler has a setting that only shaders can use",
                         "give the sampler only a \"filter\", or use a fullscreen pass"};
    if (from.range.mips != 1 || to.range.mips != 1)
        return BlitFault{
            "a blit copies only one mip to one mip",
            "select one mip: " + quote((from.range.mips != 1 ? source : target).name + ".mip(0)")};
    if (from.range.layers != to.range.layers)
        return BlitFault{
            "they have different numbers of layers",
            "select layers: " +
                quote((from.range.layers > to.range.layers ? source : target).name + ".layer(0)")};
    return std::nullopt;
}

void check_blit(const VersionedGraph& graph, const PassDecl& decl, PassId pass, const Suspects& suspects,
                PassReporter& report) {
    const UseDecl& from = graph.passes[pass].uses[0];
    const UseDecl& to = graph.passes[pass].uses[1];
    if (suspects.shapes[from.resource] || suspects.shapes[to.resource]) return;
    const std::optional<BlitFault> fault = blit_fault(graph.resources, from, to);
    if (!fault) return;
    Diagnostic& d =
        report.error(pass, to.loc, "W183",
                     "blit pass " + quote(decl.name) + " cannot copy from " +
                         quote(range_of(graph.resources[from.resource], from.range)) + " to " +
                         quote(range_of(graph.resources[to.resource], to.range)) + ": " + fault->reason);
    add_help(d, fault->remedy);
}

}  // namespace

void check_copy(const Declared& declared, const VersionedGraph& graph, PassId pass, const Suspects& suspects,
                PassReporter& report) {
    const PassDecl& decl = declared.expansion.passes[pass].decl;
    const std::vector<UseDecl>& uses = graph.passes[pass].uses;
    if (uses.size() != 2) return;
    if (decl.kind == PassKind::blit) return check_blit(graph, decl, pass, suspects, report);
    const UseDecl& from = uses[0];
    const UseDecl& to = uses[1];
    if (suspects.shapes[from.resource] || suspects.shapes[to.resource]) return;
    if (same_shape(graph.resources, from, to)) return;
    Diagnostic& d =
        report.error(pass, to.loc, "W183",
                     "copy pass " + quote(decl.name) + " has an input and an output of different shape: " +
                         shape_text(graph.resources, from) + " and " + shape_text(graph.resources, to));
    add_help(d, "give both the same size, mips, layers and bytes per texel, or use a fullscreen pass");
}

}  // namespace weft
