#include "graph/resolve/live/check_areas.h"

#include "graph/resolve/fault_text.h"

namespace weft {
namespace {

bool same_area(const ResolvedGraph& graph, const LiveArea& a, const LiveArea& b) {
    const bool is_live = a.image != kNoId && b.image != kNoId;
    if (!is_live) return a.image == b.image;
    return graph.resources[a.image].area == graph.resources[b.image].area && a.mip == b.mip;
}

// Returns the area of a port for messages, such as "the area of \"render\"".
std::string area_text(const Declared& declared, const ResolvedGraph& graph, const UseDecl& use) {
    const LiveArea area = area_of(graph, use);
    if (area.image == kNoId) return quote(use.port) + " is used as a whole";
    const ResourceDesc* desc = declared.shapes.origins[use.resource].desc;
    const std::string size = desc != nullptr && !desc->size.empty() ? desc->size.text : "render";
    return quote(use.port) + " has the area of " +
           (area.mip > 0 ? "mip " + std::to_string(area.mip) + " of " : "") + quote(size);
}

std::vector<uint32_t> attachments_of(const PassDecl& pass) {
    std::vector<uint32_t> uses;
    for (const AttachmentDecl& color : pass.colors) {
        uses.push_back(color.use);
        if (color.resolve_use != kNoId) uses.push_back(color.resolve_use);
    }
    if (pass.depth) uses.push_back(pass.depth->use);
    return uses;
}

}  // namespace

LiveArea area_of(const ResolvedGraph& graph, const UseDecl& use) {
    if (graph.resources[use.resource].area == kNoId) return {};
    return {use.resource, use.range.mip};
}

void check_live_image(const ResourceDecl& image, const ResourceDesc& desc, Reporter& reporter) {
    const auto refuse = [&](const std::string& why, const std::string& help) {
        add_help(reporter.error(desc.size.empty() ? desc.loc : desc.size.loc, "W236",
                                quote(desc.name) + " has a live size, but " + why),
                 help);
    };
    if (!desc.file.name.empty())
        refuse("its content comes from a file", "remove \"size\": the size comes from the file");
    else if (desc.keep == KeepMode::shared)
        refuse("tiers that share it may use other areas", "set \"keep\": true");
    else if (desc.keep != KeepMode::none && image.history > 0)
        refuse("content of the last frame may have another area, so it cannot be carried to this frame",
               "remove \"keep\"");
    else if (image.image_kind == ImageKind::cube || image.image_kind == ImageKind::cube_array)
        refuse("a direction in a cube selects texels of the whole face",
               "give the cube a size without a scale");
}

void check_pass_areas(const Declared& declared, const VersionedGraph& versioned, PassId id,
                      const ResolvedGraph& graph, PassReporter& report) {
    const PassDecl& pass = graph.passes[id];
    const auto refuse = [&](SourceLoc loc, const std::string& message, const std::string& help) {
        add_help(report.error(id, loc, "W236", message), help);
    };
    const auto compare = [&](const UseDecl& a, const UseDecl& b, const std::string& what,
                             const std::string& help) {
        if (versioned.suspects.shapes[a.resource] || versioned.suspects.shapes[b.resource]) return true;
        if (same_area(graph, area_of(graph, a), area_of(graph, b))) return true;
        refuse(b.loc,
               what + " of pass " + quote(pass.name) + " differ in area: " + area_text(declared, graph, a) +
                   ", " + area_text(declared, graph, b),
               help);
        return false;
    };
    const std::vector<uint32_t> attachments = attachments_of(pass);
    for (const uint32_t use : attachments)
        if (!compare(pass.uses[attachments.front()], pass.uses[use], "attachments",
                     "give all attachments the same \"size\" and mip"))
            return;
    if (pass.kind == PassKind::copy && pass.uses.size() == 2)
        if (!compare(pass.uses[0], pass.uses[1], "source and target",
                     "give both the same \"size\" and mip, or set \"type\": \"blit\", which scales the area"))
            return;
    for (const UseDecl& use : pass.uses) {
        const bool filtered = pass.kind == PassKind::blit && use.sampler.filter == SamplerFilter::linear;
        if (!use.is_output && filtered && graph.resources[use.resource].area != kNoId)
            return refuse(
                use.loc,
                "pass " + quote(pass.name) + " blits " + quote(use.port) +
                    ", which has a live size, with a linear filter; at the edge of the area, the "
                    "filter reads texels without content",
                "set \"sampler\": { \"filter\": \"nearest\" } for the input, or use a fullscreen pass "
                "that samples at area_uv()");
        if (!use.is_output || graph.resources[use.resource].area == kNoId) continue;
        const ResourceDesc* desc = declared.shapes.origins[use.resource].desc;
        const PassDraft& draft = declared.expansion.passes[id];
        if (desc != nullptr && desc->keep == KeepMode::frames && !draft.desc->rests && draft.group == kNoId &&
            !pass.carries)
            return refuse(use.loc,
                          "pass " + quote(pass.name) + " writes " + quote(use.port) +
                              ", which has a live size and \"keep\"; after a change of the area, it would "
                              "contain parts that were written for another area",
                          "add \"rest\": true to the pass, or use \"history\": 1 instead of \"keep\"");
        if (pass.kind == PassKind::custom)
            return refuse(use.loc,
                          "pass " + quote(pass.name) + " is a pass in C++ and writes " + quote(use.port) +
                              ", which has a live size",
                          "give this image a size without a scale");
        if (draft.group != kNoId)
            return refuse(use.loc,
                          "pass " + quote(pass.name) + " belongs to a group and writes " + quote(use.port) +
                              ", which has a live size; a round that waits for its turn would leave the "
                              "content of another area",
                          "give this image a size without a scale");
    }
}

}  // namespace weft
