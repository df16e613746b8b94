// Colour attachments by the location of the fragment output, the depth attachment, and the one extent they
// share.
#include <algorithm>

#include "graph/resolve/resolve_context.h"

namespace weft {
namespace {

class AttachmentStep {
 public:
    AttachmentStep(ResolveState& state, PassId pass)
        : state_(state), pass_(pass), work_(state.passes[pass]), decl_(state.graph.passes[pass]) {}

    void run() {
        for (uint32_t i = 0; i < decl_.uses.size(); ++i) {
            if (work_.ports[i].color_output) add_color(i);
            if (work_.ports[i].is_depth_port) add_depth(i);
        }
        std::ranges::sort(decl_.colors, {}, &AttachmentDecl::location);
        const uint32_t limit = state_.input.profile.max_color_attachments;
        if (decl_.colors.size() > limit) {
            error(decl_.loc, "W180",
                  "pass " + quoted(decl_.name) + " has " + std::to_string(decl_.colors.size()) +
                      " colour outputs; the device offers " + std::to_string(limit),
                  "split the pass, or pack its outputs");
        }
        check_agreement();
        check_stencil();
        check_viewport();
        for (const ResolveDesc& resolve : desc().resolves) add_resolve(resolve);
    }

 private:
    const PassDesc& desc() const { return *work_.desc; }

    void error(SourceLoc loc, const char* code, const std::string& message, const std::string& help) {
        add_help(state_.pass_error(pass_, loc, code, message), help);
    }

    std::array<float, 4> clear_value(const UseDecl& use) {
        const auto own = desc().clear_ports.find(use.port);
        if (own != desc().clear_ports.end()) return state_.color_here(own->second);
        const ResourceDecl& resource = state_.graph.resources[use.resource];
        // The pass's own value is a colour.
        if (desc().clear && !(resource.aspects & aspect::kDepth)) return state_.color_here(*desc().clear);
        // Reversed depth: 0 is infinitely far.
        return resource.clear.value_or(std::array<float, 4>{0, 0, 0, 0});
    }

    void add_color(uint32_t index) {
        const UseDecl& use = decl_.uses[index];
        AttachmentDecl color;
        color.use = index;
        color.location = work_.ports[index].color_output->location;
        color.blend = blend_of(desc(), use.port);
        color.clear = clear_value(use);
        const bool explicitly_cleared = desc().clear || desc().clear_ports.contains(use.port);
        color.covers = work_.ports[index].rank == WriteRank::fresh && !explicitly_cleared;
        decl_.colors.push_back(color);
        check_range(use);
    }

    void add_depth(uint32_t index) {
        AttachmentDecl depth;
        depth.use = index;
        depth.clear = clear_value(decl_.uses[index]);
        decl_.depth = depth;
        check_range(decl_.uses[index]);
    }

    void check_stencil() {
        if (!desc().state.stencil_test || desc().depth || work_.faulty) return;
        error(decl_.loc, "W182",
              "the state of pass " + quoted(decl_.name) +
                  " tests stencil, but the pass has no depth attachment",
              "name one with stencil, \"depth\": \"image\" of format \"d32f_s8|d24_s8\"; or remove "
              "\"stencil\"");
    }

    // A device that draws into images of a side has viewports of it, and places them within twice as much.
    void check_viewport() {
        if (!decl_.state.viewport) return;
        const RectPx& view = *decl_.state.viewport;
        const int64_t side = state_.input.profile.max_image_2d_px;
        const auto fits = [&](int64_t place, int64_t extent) {
            return extent <= side && place >= -2 * side && place + extent <= 2 * side - 1;
        };
        if (fits(view.x, view.width) && fits(view.y, view.height)) return;
        error(decl_.loc, "W119",
              "the viewport of pass " + quoted(decl_.name) + " is " + std::to_string(view.width) + "x" +
                  std::to_string(view.height) + " px at " + std::to_string(view.x) + ", " +
                  std::to_string(view.y),
              "the device offers " + std::to_string(side) + " px a side, from " + std::to_string(-2 * side) +
                  " to " + std::to_string(2 * side - 1));
    }

    void add_resolve(const ResolveDesc& resolve) {
        const auto port = std::ranges::find(work_.ports, &resolve.target, &PortWork::desc);
        if (port == work_.ports.end()) return;  // reported
        const auto target = static_cast<uint32_t>(port - work_.ports.begin());
        const auto color = std::ranges::find_if(
            decl_.colors, [&](const AttachmentDecl& c) { return decl_.uses[c.use].port == resolve.output; });
        const std::string what = "output " + quoted(resolve.output) + " of pass " + quoted(decl_.name);
        if (color == decl_.colors.end()) {
            if (!work_.faulty)
                error(resolve.output_loc, "W179", what + " is no colour attachment",
                      "only those are resolved");
            return;
        }
        if (color->resolve_use != kNoId)
            return error(resolve.output_loc, "W179", what + " is resolved twice",
                         "resolve it once, and copy the result");
        color->resolve_use = target;
        check_range(decl_.uses[target]);
        check_resolve(decl_.uses[color->use], decl_.uses[target]);
    }

    void check_resolve(const UseDecl& from, const UseDecl& to) {
        const ResourceDecl& many = state_.graph.resources[from.resource];
        const ResourceDecl& one = state_.graph.resources[to.resource];
        if (state_.resources[from.resource].suspect_shape || state_.resources[to.resource].suspect_shape)
            return;
        const std::string what = "pass " + quoted(decl_.name) + " can't resolve " + quoted(many.name) +
                                 " into " + quoted(one.name) + ": ";
        if (one.kind == ResourceKind::buffer)
            return error(to.loc, "W179", what + "that is a buffer", "name an image");
        if (many.samples == 1)
            return error(to.loc, "W179", what + "the former has one sample a pixel",
                         "give it \"samples\": 4, or write " + quoted(one.name) + " directly");
        if (one.samples != 1)
            return error(to.loc, "W179", what + "both are multisampled",
                         "remove \"samples\" of " + quoted(one.name));
        if (many.format != one.format)
            return error(to.loc, "W179", what + "their formats differ", "give both the same format");
        if (use_extent(state_, to) != decl_.render_extent)
            error(to.loc, "W179",
                  what + "they are " + extent_text(decl_.render_extent) + " and " +
                      extent_text(use_extent(state_, to)),
                  "give both the same size, and pick the mip");
    }

    void check_range(const UseDecl& use) {
        const ResourceDecl& resource = state_.graph.resources[use.resource];
        if (resource.image_kind == ImageKind::d3)
            return error(use.loc, "W169",
                         "attachment " + quoted(use.port) + " of pass " + quoted(decl_.name) +
                             " is the 3D image " + quoted(resource.name),
                         "write 3D images in a compute pass, or use an array");
        if (use.range.mips == 1 && use.range.layers == 1) return;
        const std::string pick =
            resource.name + (use.range.mips > 1 ? ".mip(0)" : "") + (use.range.layers > 1 ? ".layer(0)" : "");
        error(use.loc, "W169",
              "attachment " + quoted(use.port) + " of pass " + quoted(decl_.name) +
                  " is one mip of one layer, but " + quoted(range_of(resource, use.range)) + " has " +
                  std::to_string(use.range.mips) + " mips and " + std::to_string(use.range.layers) +
                  " layers",
              "pick one: " + quoted(pick));
    }

    std::vector<uint32_t> attachment_uses() const {
        std::vector<uint32_t> uses;
        for (const AttachmentDecl& color : decl_.colors) uses.push_back(color.use);
        if (decl_.depth) uses.push_back(decl_.depth->use);
        return uses;
    }

    void check_agreement() {
        const std::vector<uint32_t> uses = attachment_uses();
        if (uses.empty()) {
            if (work_.faulty) return;
            error(decl_.loc, "W181", "pass " + quoted(decl_.name) + " has no attachment to draw into",
                  "name a fragment output in \"out\", or a \"depth\"");
            return;
        }
        const UseDecl& first = decl_.uses[uses.front()];
        decl_.render_extent = use_extent(state_, first);
        for (const uint32_t index : uses) {
            const UseDecl& use = decl_.uses[index];
            if (state_.resources[use.resource].suspect_shape ||
                state_.resources[first.resource].suspect_shape)
                continue;
            const Extent3D extent = use_extent(state_, use);
            if (extent != decl_.render_extent) {
                error(use.loc, "W174",
                      "attachments of pass " + quoted(decl_.name) + " differ in size: " + quoted(first.port) +
                          " is " + extent_text(decl_.render_extent) + ", " + quoted(use.port) + " is " +
                          extent_text(extent),
                      "give them the same \"size\" and mip");
                return;
            }
            const uint32_t samples = state_.graph.resources[use.resource].samples;
            const uint32_t wanted = state_.graph.resources[first.resource].samples;
            if (samples != wanted) {
                error(use.loc, "W174",
                      "attachments of pass " + quoted(decl_.name) +
                          " differ in samples: " + quoted(first.port) + " has " + std::to_string(wanted) +
                          ", " + quoted(use.port) + " has " + std::to_string(samples),
                      "give them the same \"samples\"");
                return;
            }
        }
    }

    ResolveState& state_;
    PassId pass_;
    PassWork& work_;
    PassDecl& decl_;
};

}  // namespace

void resolve_attachments(ResolveState& state) {
    for (PassId pass = 0; pass < state.passes.size(); ++pass) {
        const PassKind kind = state.graph.passes[pass].kind;
        const bool draws = kind == PassKind::raster || kind == PassKind::fullscreen;
        if (draws && state.passes[pass].shader) AttachmentStep(state, pass).run();
    }
}

}  // namespace weft
