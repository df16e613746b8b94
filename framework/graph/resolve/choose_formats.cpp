#include "graph/resolve/choose_formats.h"

#include <algorithm>
#include <array>

#include "graph/diagnostics/quantity_text.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/pass_ports.h"
#include "graph/resolve/rings.h"

namespace weft {
namespace {

// Format features that a resource needs besides those that follow from its usage flags.
struct Needs {
    bool blend = false;
    bool blit_from = false, blit_to = false;
    bool min_max = false;  // True if a sampler has the reduction `min` or `max`.
    // True if a port states a sampler with linear filtering, so that the format must support it.
    bool linear_always = false;
    // True if a port uses the default sampler, or if the image is resampled when its size changes. Both
    // filter linearly only if shaders read the format as floats (float, unorm, snorm or sRGB).
    bool linear_if_float = false;
};

struct FeatureRow {
    FormatFeatureMask bit;
    const char* name;
};
constexpr std::array kFeatureRows{
    FeatureRow{format_feature::kSampled, "sampling"},
    FeatureRow{format_feature::kSampledLinear, "linear filtering"},
    FeatureRow{format_feature::kSampledMinMax, "the sampler reductions min and max"},
    FeatureRow{format_feature::kStorage, "storage images"},
    FeatureRow{format_feature::kColorAttachment, "colour attachments"},
    FeatureRow{format_feature::kColorBlend, "blending"},
    FeatureRow{format_feature::kDepthAttachment, "depth attachments"},
    FeatureRow{format_feature::kTransferSrc, "use as a copy source"},
    FeatureRow{format_feature::kTransferDst, "use as a copy target, or clearing"},
    FeatureRow{format_feature::kBlitSrc, "use as a blit source"},
    FeatureRow{format_feature::kBlitDst, "use as a blit target"},
};

std::string features_text(FormatFeatureMask mask) {
    std::string text;
    for (const FeatureRow& row : kFeatureRows) {
        if (mask & row.bit) text += (text.empty() ? "" : ", ") + std::string(row.name);
    }
    return text;
}

bool is_float(Format format) {
    return format_info(format).numeric == NumericClass::float_like;
}

FormatFeatureMask features_needed(UsageMask usages, const Needs& needs, Format format) {
    constexpr std::array<std::pair<UsageMask, FormatFeatureMask>, 6> kPairs{{
        {usage::kSampled, format_feature::kSampled},
        {usage::kStorage, format_feature::kStorage},
        {usage::kColorAttachment, format_feature::kColorAttachment},
        {usage::kDepthAttachment, format_feature::kDepthAttachment},
        {usage::kTransferSrc, format_feature::kTransferSrc},
        {usage::kTransferDst, format_feature::kTransferDst},
    }};
    FormatFeatureMask mask = 0;
    for (const auto& [used, feature] : kPairs) {
        if (usages & used) mask |= feature;
    }
    if (needs.blend) mask |= format_feature::kColorBlend;
    if (needs.blit_from) mask |= format_feature::kBlitSrc;
    if (needs.blit_to) mask |= format_feature::kBlitDst;
    if (needs.min_max) mask |= format_feature::kSampledMinMax;
    if (needs.linear_always || (needs.linear_if_float && is_float(format)))
        mask |= format_feature::kSampledLinear;
    return mask;
}

bool takes_average(const SamplerDecl& sampler) {
    return sampler.reduction == SamplerReduction::average;
}

// Returns true if the format must support linear filtering. The reductions `min` and `max` need another
// feature instead.
bool filters_linearly(const SamplerDecl& sampler, uint32_t mips) {
    if (!takes_average(sampler)) return false;
    return sampler.filter == SamplerFilter::linear ||
           (mips > 1 && sampler.mip_filter == SamplerFilter::linear);
}

// Returns the number of mips that the port samples. For a table of textures, returns 2, because its textures
// may have several mips.
uint32_t sampled_mips(const ResourceDecl& resource, const UseDecl& use) {
    constexpr uint32_t kSeveral = 2;
    return resource.textures > 0 ? kSeveral : element_range(use, 0).mips;
}

// If the resource has a history, returns the resource of the current frame (age 0). Otherwise returns `id`
// itself. The copies of a resource with history change their roles every frame ("x" becomes "x[-1]"). So the
// requirements of all roles are collected at age 0, and every copy must meet them.
ResourceId base_of(const std::vector<ResourceDecl>& resources, ResourceId id) {
    const ResourceId ring = resources[id].ring;
    return ring == kNoId ? id : ring;
}

// Adds transfer usage to persistent resources. The first content of such a resource comes from a clear. If
// the plan replaces an old plan, the content is copied from the resource of the old plan instead.
void need_transfers(std::vector<ResourceDecl>& resources) {
    for (ResourceDecl& resource : resources) {
        if (resource.lifetime == ResourceLifetime::persistent)
            resource.usage |= usage::kTransferSrc | usage::kTransferDst;
    }
}

// Adds the features for a blit to images with "onResize": "resample". When such an image changes its size,
// its old content is scaled to the new size by a blit.
void need_resampling(const std::vector<ResourceDecl>& resources, std::vector<Needs>& needs) {
    for (ResourceId id(0); id < resources.size(); ++id) {
        const ResourceDecl& decl = resources[id];
        if (decl.kind != ResourceKind::image || decl.on_resize != OnResize::resample) continue;
        needs[id].blit_from = needs[id].blit_to = needs[id].linear_if_float = true;
    }
}

bool is_filtered(Access a) {
    return a == Access::sampled_read || a == Access::blit_read;
}

// Returns false if the shader reads only single texels at the port, with texelFetch().
bool may_filter(const PortDraft& port) {
    return port.binding == nullptr || port.binding->filters;
}

// Adds the usage flags of all uses to the resources, and returns the further requirements of each resource.
std::vector<Needs> gather_needs(const Declared& declared, FormattedGraph& graph) {
    std::vector<Needs> needs(graph.resources.size());
    for (PassId id(0); id < graph.passes.size(); ++id) {
        const PassDesc& desc = *declared.expansion.passes[id].desc;
        const BoundPass& pass = graph.passes[id];
        const std::vector<UseDecl>& uses = pass.uses;
        for (size_t i = 0; i < uses.size(); ++i) {
            const ResourceId base = base_of(graph.resources, uses[i].resource);
            Needs& need = needs[base];
            graph.resources[base].usage |= usage_of(uses[i].access);
            if (pass.ports[i].color_output && blend_of(desc, uses[i].port).enabled) need.blend = true;
            need.blit_from |= uses[i].access == Access::blit_read;
            need.blit_to |= uses[i].access == Access::blit_write;
            if (!is_filtered(uses[i].access)) continue;
            const std::optional<SamplerDecl>& sampler = pass.ports[i].desc->sampler;
            if (sampler)
                need.linear_always |=
                    filters_linearly(*sampler, sampled_mips(graph.resources[base], uses[i]));
            if (sampler && uses[i].access == Access::sampled_read) need.min_max |= !takes_average(*sampler);
            if (!sampler && may_filter(pass.ports[i])) need.linear_if_float = true;
        }
    }
    return needs;
}

void set_format(ResourceDecl& decl, Format format) {
    decl.format = format;
    const FormatInfo& info = format_info(format);
    decl.aspects =
        static_cast<AspectMask>((info.depth ? aspect::kDepth : 0) | (info.stencil ? aspect::kStencil : 0));
    if (decl.aspects == aspect::kNone) decl.aspects = aspect::kColor;
}

std::optional<std::vector<Format>> list_candidates(const ResourceDesc& desc, Reporter& reporter) {
    std::vector<Format> formats;
    for (const std::string& name : desc.formats) {
        if (const std::optional<Format> format = format_from_name(name)) {
            formats.push_back(*format);
            continue;
        }
        Diagnostic& d = reporter.error(desc.loc, "W116",
                                       "resource " + quote(desc.name) + " has unknown format " + quote(name));
        const std::string near = did_you_mean_text(name, format_names());
        add_help(d, near.empty() ? "allowed formats are " + quote_all(format_names()) : near);
    }
    if (formats.size() == desc.formats.size()) return formats;
    return std::nullopt;
}

std::string counts_text(SampleCountMask counts) {
    std::string text;
    for (uint32_t count = 1; count <= counts && count != 0; count <<= 1)
        if (counts & count) text += (text.empty() ? "" : ", ") + std::to_string(count);
    return text;
}

// Checks the sample count of an image. The format must already be chosen, because it determines which sample
// counts the device supports.
bool check_samples(const DeviceProfile& profile, const ResourceDecl& decl, Reporter& reporter) {
    const SampleCountMask offered = profile.samples(decl.format);
    if (decl.samples == 1 || (offered & decl.samples) != 0) return true;
    const std::string format = quote(format_info(decl.format).name);
    Diagnostic& d =
        reporter.error(decl.loc, "W119",
                       "image " + quote(decl.name) + " has " + std::to_string(decl.samples) +
                           " samples; the device supports " + counts_text(offered) + " for " + format);
    add_help(d, offered > 1 ? "choose one of these numbers" : "remove \"samples\", or use another format");
    add_help(d, "the limit comes from the device profile " + quote(profile.name));
    return false;
}

// Chooses the first format of the list that the device supports for all usages. Does not try the formats that
// ResolveInput::skipped_formats skips. Returns false after reporting an error.
bool choose_format(const ResolveInput& input, const ResourceDesc& desc, const Needs& needs,
                   ResourceDecl& decl, Reporter& reporter) {
    const std::optional<std::vector<Format>> formats = list_candidates(desc, reporter);
    if (!formats) return false;
    std::vector<std::string> reasons;
    const auto skipped = input.skipped_formats.find(desc.name);
    const size_t first = skipped != input.skipped_formats.end() ? skipped->second : 0;
    for (size_t i = std::min(first, formats->size() - 1); i < formats->size(); ++i) {
        const Format format = (*formats)[i];
        const FormatFeatureMask missing =
            features_needed(decl.usage, needs, format) & ~input.profile.features(format);
        if (missing == 0) {
            set_format(decl, format);
            if (decl.image_kind != ImageKind::d3 || decl.aspects == aspect::kColor)
                return check_samples(input.profile, decl, reporter);
            add_help(reporter.error(desc.loc, "W109", "3D image " + quote(desc.name) + " has a depth format"),
                     "use a colour format, or an array");
            return false;
        }
        reasons.push_back(quote(format_info(format).name) + " does not support " + features_text(missing));
    }
    Diagnostic& d = reporter.error(
        desc.loc, "W117",
        quote(desc.name) + " has no format that the device supports for every use of the image");
    for (std::string& reason : reasons) add_help(d, std::move(reason));
    add_help(d, reasons.empty() ? "name a format"
                                : "add another format: \"a|b\" uses b if the device does not support a");
    return false;
}

void complete_use(const ResourceDecl& resource, const PortDraft& port, UseDecl& use) {
    if (resource.kind == ResourceKind::image && use.range.aspects == aspect::kNone) {
        use.range.aspects = resource.aspects;
        // A sampled image view of a depth-stencil format can only show one aspect; the default is depth.
        if (use.access == Access::sampled_read && (resource.aspects & aspect::kDepth))
            use.range.aspects = aspect::kDepth;
    }
    if (!is_filtered(use.access)) return;
    if (!port.desc->sampler && !(is_float(resource.format) && may_filter(port)))
        use.sampler.filter = use.sampler.mip_filter = SamplerFilter::nearest;
    if (!port.binding) return;
    // With a single mip there are no neighbouring mips to filter between.
    if (sampled_mips(resource, use) == 1) use.sampler.mip_filter = SamplerFilter::nearest;
    if (port.binding->shadow && !use.sampler.compare) use.sampler.compare = CompareOp::greater_equal;
}

// Returns true if the resource has at most `limit_bytes` bytes. First compares the size of the first mip as
// floating point, because the integer product could exceed 2^64.
bool fits(const ResourceDecl& resource, uint64_t limit_bytes) {
    const Extent3D& e = resource.extent;
    const double first_mip_bytes = double{1} * e.width * e.height * e.depth * resource.layers *
                                   resource.samples * format_info(resource.format).bytes_per_texel;
    const bool image = resource.kind == ResourceKind::image;
    if (image && first_mip_bytes > static_cast<double>(limit_bytes)) return false;
    return content_bytes(resource) <= limit_bytes;
}

// Reports each resource that alone exceeds the limit graph.transientBytes, with its place in the file. The
// sum of all resources is checked later, when a plan is made.
void check_sizes(const Declared& declared, FormattedGraph& graph, Reporter& reporter) {
    const uint64_t limit_bytes = declared.input.limits.transient_bytes;
    for (ResourceId id(0); id < graph.resources.size(); ++id) {
        const ResourceDesc* desc = declared.shapes.origins[id].desc;
        if (!desc || graph.suspects.shapes[id] || graph.resources[id].age > 0) continue;
        if (fits(graph.resources[id], limit_bytes)) continue;
        graph.suspects.shapes[id] = 1;
        Diagnostic& d = reporter.error(
            desc->loc, "W125",
            quote(desc->name) + " needs more than " + limit_bytes_text(limit_bytes) + " of memory");
        add_help(d, "make the resource smaller, " + raise_limit_text("graph.transientBytes"));
    }
}

}  // namespace

FormattedGraph choose_formats(const Declared& declared, BoundPasses bound, Reporter& reporter) {
    FormattedGraph graph{.resources = declared.shapes.resources,
                         .passes = std::move(bound.passes),
                         .suspects = std::move(bound.suspects)};
    for (ResourceId id(0); id < bound.cuts_bytes.size(); ++id)
        graph.resources[id].cuts_bytes = std::move(bound.cuts_bytes[id]);
    need_transfers(graph.resources);
    std::vector<Needs> needs = gather_needs(declared, graph);
    need_resampling(graph.resources, needs);
    for (ResourceId id(0); id < graph.resources.size(); ++id) {
        const ResourceDesc* desc = declared.shapes.origins[id].desc;
        if (!desc || desc->is_buffer || graph.resources[id].age > 0) continue;
        if (!choose_format(declared.input, *desc, needs[id], graph.resources[id], reporter))
            graph.suspects.shapes[id] = 1;
    }
    check_sizes(declared, graph, reporter);
    spread_over_rings(graph.resources, graph.suspects);
    for (BoundPass& pass : graph.passes) {
        for (size_t i = 0; i < pass.uses.size(); ++i)
            complete_use(graph.resources[pass.uses[i].resource], pass.ports[i], pass.uses[i]);
    }
    return graph;
}

}  // namespace weft
