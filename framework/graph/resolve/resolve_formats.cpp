// The union of a resource's usages picks its format: the first that the device supports for all of them.
// Aspects follow from the format, and with them every use is complete.
#include <algorithm>
#include <array>

#include "graph/diagnostics/quantity_text.h"
#include "graph/resolve/resolve_context.h"

namespace weft {
namespace {

// What one resource must be good for, beyond its usages.
struct Needs {
    bool blend = false;
    bool blit_from = false, blit_to = false;
    bool linear_always = false;    // a sampler that says so
    bool linear_if_float = false;  // the default sampler
};

struct FeatureRow {
    FormatFeatureMask bit;
    const char* name;
};
constexpr std::array kFeatureRows{
    FeatureRow{format_feature::kSampled, "sampling"},
    FeatureRow{format_feature::kSampledLinear, "linear filtering"},
    FeatureRow{format_feature::kStorage, "storage images"},
    FeatureRow{format_feature::kColorAttachment, "colour attachments"},
    FeatureRow{format_feature::kColorBlend, "blending"},
    FeatureRow{format_feature::kDepthAttachment, "depth attachments"},
    FeatureRow{format_feature::kTransferSrc, "copying from"},
    FeatureRow{format_feature::kTransferDst, "copying or clearing to"},
    FeatureRow{format_feature::kBlitSrc, "blitting from"},
    FeatureRow{format_feature::kBlitDst, "blitting to"},
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
    if (needs.linear_always || (needs.linear_if_float && is_float(format)))
        mask |= format_feature::kSampledLinear;
    return mask;
}

bool filters_linearly(const SamplerDecl& sampler, uint32_t mips) {
    return sampler.filter == SamplerFilter::linear ||
           (mips > 1 && sampler.mip_filter == SamplerFilter::linear);
}

// The memory of a ring serves all its roles in turn, so all their needs are one.
ResourceId base_of(const ResolveState& state, ResourceId id) {
    const ResourceId ring = state.graph.resources[id].ring;
    return ring == kNoId ? id : ring;
}

// What was there before the first frame is a clear, or what another plan left behind.
void need_transfers(ResolveState& state) {
    for (ResourceDecl& resource : state.graph.resources) {
        if (resource.lifetime == ResourceLifetime::persistent)
            resource.usage |= usage::kTransferSrc | usage::kTransferDst;
    }
}

// A content that follows its resource's size is blitted there.
void need_resampling(const ResolveState& state, std::vector<Needs>& needs) {
    for (ResourceId id = 0; id < state.resources.size(); ++id) {
        const ResourceDecl& decl = state.graph.resources[id];
        if (decl.kind != ResourceKind::image || decl.on_resize != OnResize::resample) continue;
        needs[id].blit_from = needs[id].blit_to = needs[id].linear_if_float = true;
    }
}

bool is_filtered(Access a) {
    return a == Access::sampled_read || a == Access::blit_read;
}

std::vector<Needs> gather_needs(ResolveState& state) {
    std::vector<Needs> needs(state.resources.size());
    for (PassId id = 0; id < state.passes.size(); ++id) {
        const PassWork& work = state.passes[id];
        const std::vector<UseDecl>& uses = state.graph.passes[id].uses;
        for (size_t i = 0; i < uses.size(); ++i) {
            const ResourceId base = base_of(state, uses[i].resource);
            Needs& need = needs[base];
            state.graph.resources[base].usage |= usage_of(uses[i].access);
            if (work.ports[i].color_output && blend_of(*work.desc, uses[i].port).enabled) need.blend = true;
            need.blit_from |= uses[i].access == Access::blit_read;
            need.blit_to |= uses[i].access == Access::blit_write;
            if (!is_filtered(uses[i].access)) continue;
            const std::optional<SamplerDecl>& sampler = work.ports[i].desc->sampler;
            if (sampler) need.linear_always |= filters_linearly(*sampler, uses[i].range.mips);
            if (!sampler) need.linear_if_float = true;
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

std::optional<std::vector<Format>> candidates(ResolveState& state, const ResourceDesc& desc) {
    std::vector<Format> formats;
    for (const std::string& name : desc.formats) {
        if (const std::optional<Format> format = format_from_name(name)) {
            formats.push_back(*format);
            continue;
        }
        Diagnostic& d = state.error(desc.loc, "W116",
                                    "resource " + quoted(desc.name) + " has unknown format " + quoted(name));
        const std::string near = did_you_mean_text(name, format_names());
        add_help(d, near.empty() ? "formats are " + joined(format_names()) : near);
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

// Which numbers of samples there are depends on the format.
bool check_samples(ResolveState& state, const ResourceDecl& decl) {
    const SampleCountMask offered = state.input.profile.samples(decl.format);
    if (decl.samples == 1 || (offered & decl.samples) != 0) return true;
    const std::string format = quoted(format_info(decl.format).name);
    Diagnostic& d = state.error(decl.loc, "W119",
                                "image " + quoted(decl.name) + " has " + std::to_string(decl.samples) +
                                    " samples; the device offers " + counts_text(offered) + " for " + format);
    add_help(d, offered > 1 ? "give it one of these" : "remove \"samples\", or use another format");
    add_help(d, "the limit comes from the device profile " + quoted(state.input.profile.name));
    return false;
}

bool choose_format(ResolveState& state, ResourceDecl& decl, const ResourceDesc& desc, const Needs& needs) {
    const std::optional<std::vector<Format>> formats = candidates(state, desc);
    if (!formats) return false;
    std::vector<std::string> reasons;
    const auto skipped = state.input.skipped_formats.find(desc.name);
    const size_t first = skipped != state.input.skipped_formats.end() ? skipped->second : 0;
    for (size_t i = std::min(first, formats->size() - 1); i < formats->size(); ++i) {
        const Format format = (*formats)[i];
        const FormatFeatureMask missing =
            features_needed(decl.usage, needs, format) & ~state.input.profile.features(format);
        if (missing == 0) {
            set_format(decl, format);
            if (decl.image_kind != ImageKind::d3 || decl.aspects == aspect::kColor)
                return check_samples(state, decl);
            add_help(state.error(desc.loc, "W109", "3D image " + quoted(desc.name) + " has a depth format"),
                     "use a colour format, or an array");
            return false;
        }
        reasons.push_back(quoted(format_info(format).name) + " lacks " + features_text(missing));
    }
    Diagnostic& d = state.error(
        desc.loc, "W117",
        "the device supports no format of " + quoted(desc.name) + " for all that passes do with it");
    for (std::string& reason : reasons) add_help(d, std::move(reason));
    add_help(d, reasons.empty() ? "name a format" : "add a fallback: \"a|b\" takes the first that works");
    return false;
}

void complete_use(const ResolveState& state, UseDecl& use, const PortWork& port) {
    const ResourceDecl& resource = state.graph.resources[use.resource];
    if (resource.kind == ResourceKind::buffer) {
        use.range.aspects = aspect::kColor;
    } else if (use.range.aspects == aspect::kNone) {
        use.range.aspects = resource.aspects;
        // A sampled view shows one aspect.
        if (use.access == Access::sampled_read && (resource.aspects & aspect::kDepth))
            use.range.aspects = aspect::kDepth;
    }
    if (!is_filtered(use.access)) return;
    if (!port.desc->sampler && !is_float(resource.format)) {
        use.sampler.filter = use.sampler.mip_filter = SamplerFilter::nearest;
    }
    if (!port.binding) return;
    // There is nothing between the mips of one mip.
    if (use.range.mips == 1) use.sampler.mip_filter = SamplerFilter::nearest;
    use.sampler.compare_greater_equal = port.binding->shadow;
}

}  // namespace

namespace {

// As floating point first: the product could pass 2^64.
bool fits(const ResourceDecl& resource, uint64_t limit_bytes) {
    const Extent3D& e = resource.extent;
    const double first_mip_bytes = double{1} * e.width * e.height * e.depth * resource.layers *
                                   resource.samples * format_info(resource.format).bytes_per_texel;
    const bool image = resource.kind == ResourceKind::image;
    if (image && first_mip_bytes > static_cast<double>(limit_bytes)) return false;
    return content_bytes(resource) <= limit_bytes;
}

// One resource that can't be placed is refused where it is written; their sum is the plan's affair.
void check_sizes(ResolveState& state) {
    const uint64_t limit_bytes = state.input.limits.transient_bytes;
    for (ResourceId id = 0; id < state.resources.size(); ++id) {
        const ResourceDesc* desc = state.resources[id].desc;
        if (!desc || state.resources[id].suspect_shape || state.graph.resources[id].age > 0) continue;
        if (fits(state.graph.resources[id], limit_bytes)) continue;
        state.resources[id].suspect_shape = true;
        Diagnostic& d = state.error(
            desc->loc, "W125",
            quoted(desc->name) + " takes more than " + limit_bytes_text(limit_bytes) + " of memory");
        add_help(d, "make it smaller, " + raise_limit_text("graph.transientBytes"));
    }
}

}  // namespace

void choose_formats(ResolveState& state) {
    need_transfers(state);
    std::vector<Needs> needs = gather_needs(state);
    need_resampling(state, needs);
    for (ResourceId id = 0; id < state.resources.size(); ++id) {
        const ResourceDesc* desc = state.resources[id].desc;
        if (!desc || desc->is_buffer || state.graph.resources[id].age > 0) continue;
        if (!choose_format(state, state.graph.resources[id], *desc, needs[id]))
            state.resources[id].suspect_shape = true;
    }
    check_sizes(state);
    spread_over_rings(state);
    for (PassId id = 0; id < state.passes.size(); ++id) {
        PassDecl& pass = state.graph.passes[id];
        for (size_t i = 0; i < pass.uses.size(); ++i)
            complete_use(state, pass.uses[i], state.passes[id].ports[i]);
    }
}

}  // namespace weft
