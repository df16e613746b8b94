#include "render/imports/output_import.h"
#include "graph/diagnostics/make_error.h"

#include <algorithm>
#include <array>

namespace weft::render {
namespace {

struct UsageRow {
    UsageMask usage;
    FormatFeatureMask feature;
    const char* text;
    const char* remedy;
};
constexpr std::array kUsageRows{
    UsageRow{usage::kColorAttachment, format_feature::kColorAttachment, "draws to it",
             "write it in a compute pass instead"},
    UsageRow{
        usage::kStorage, format_feature::kStorage, "accesses it as a storage image",
        "let the compute pass write an image of the graph, and add a fullscreen pass that copies this image "
        "to the output"},
    UsageRow{usage::kSampled, format_feature::kSampled, "samples it",
             "let the pass sample an image of the graph with the same content instead"},
    UsageRow{usage::kTransferSrc, format_feature::kTransferSrc, "copies from it",
             "let the pass copy an image of the graph with the same content instead"},
    UsageRow{usage::kTransferDst, format_feature::kTransferDst, "copies to it or clears it",
             "write it in a fullscreen pass instead"},
};

UsageMask supported_usage(const OutputFormat& output, const DeviceProfile& profile) {
    UsageMask mask = 0;
    for (const UsageRow& row : kUsageRows)
        if ((profile.features(output.format) & row.feature) != 0) mask |= row.usage;
    return output.usage != 0 ? mask & output.usage : mask;
}

// Returns the state of the output image between two frames, for its final layout. Before the next frame uses
// the image, it waits for the stages of this state. For the layout `present`, the next frame must also wait
// for the acquired image. So this state must have one of the stages in which that wait happens.
AccessState state_between(Layout layout) {
    constexpr StageMask shaders = stage::kFragmentShader | stage::kComputeShader;
    switch (layout) {
        case Layout::shader_read_only:
            return {shaders, access::kSampledRead, layout};
        case Layout::color_attachment:
            return {stage::kColorOutput, access::kColorRead | access::kColorWrite, layout};
        case Layout::present:
            return {stage::kColorOutput, access::kNone, layout};
        default:
            return {stage::kCopy | stage::kBlit, access::kTransferRead, layout};
    }
}

struct FinalLayout {
    Layout layout;
    UsageMask usage;  // The usage that an image in this layout must have.
};
constexpr std::array kFinalLayouts{FinalLayout{Layout::transfer_src, usage::kTransferSrc},
                                   FinalLayout{Layout::shader_read_only, usage::kSampled},
                                   FinalLayout{Layout::color_attachment, usage::kColorAttachment},
                                   FinalLayout{Layout::present, 0}};

// Returns an error if the output cannot have its final layout.
Status check_final_layout(const OutputFormat& output, UsageMask supported) {
    const auto row = std::ranges::find(kFinalLayouts, output.final_layout, &FinalLayout::layout);
    if (row != kFinalLayouts.end() && (row->usage & ~supported) == 0) return Unit{};
    return make_error(
        "V424", "the output cannot have the final layout " + layout_text(output.final_layout),
        {row != kFinalLayouts.end()
             ? "create the image with the usage that this layout needs, and state it in OutputFormat::usage"
             : "use one of the layouts transfer_src, shader_read_only, color_attachment and present, and a "
               "barrier of your own for all others"});
}

}  // namespace

Status check_output(const OutputFormat& output, const DeviceProfile& profile) {
    const FormatInfo& info = format_info(output.format);
    const bool color = output.format != Format::undefined && !info.depth && !info.stencil &&
                       info.numeric == NumericClass::float_like;
    const UsageMask supported = supported_usage(output, profile);
    if (color && (supported & (usage::kColorAttachment | usage::kStorage | usage::kTransferDst)) != 0)
        return check_final_layout(output, supported);
    return make_error(
        "V424",
        "no pass can write an output of the format \"" + std::string(info.name) + "\"" +
            (output.usage != 0 ? " with the given usage" : "") + " on this device",
        {"use a colour format such as rgba8, rgba8_srgb, bgra8, bgra8_srgb, rgb10a2 or rgba16f, and create "
         "the image with the usage VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT"});
}

void set_output(ImportCatalog& catalog, const GraphRequest& request, const DeviceProfile& profile) {
    ResourceDecl& image = catalog.imports.at("backbuffer").resource;
    image.extent = request.size;
    if (request.output == OutputFormat{}) return;
    catalog.numbers["outputIsLinear"] = is_linear(request.output) ? 1 : 0;
    image.format = request.output.format;
    image.usage = supported_usage(request.output, profile);
    const AccessState between = state_between(request.output.final_layout);
    image.import->entry = {between.stages, between.access, Layout::undefined};
    image.import->exit = between;
}

Diagnostics find_output_faults(const FramePlan& plan, const OutputFormat& output,
                               const DeviceProfile& profile) {
    Diagnostics faults;
    if (plan.graph.output == kNoId || output == OutputFormat{}) return faults;
    const UsageMask allowed = supported_usage(output, profile);
    for (const PassId id : plan.schedule.order) {
        const PassDecl& pass = plan.graph.passes[id];
        for (const UseDecl& use : pass.uses) {
            if (use.resource != plan.graph.output) continue;
            for (const UsageRow& row : kUsageRows) {
                if ((usage_of(use.access) & row.usage & ~allowed) == 0) continue;
                faults.push_back(plan.graph.sources.error(
                    use.loc, "V425",
                    "pass \"" + pass.name + "\" uses the output and " + row.text +
                        ", but the output image of the format \"" +
                        std::string(format_info(output.format).name) + "\" does not allow this"));
                faults.back().help = {row.remedy};
            }
        }
    }
    return faults;
}

}  // namespace weft::render
