#include "graph/resolve/attach.h"

#include <algorithm>

#include "graph/resolve/fault_text.h"
#include "graph/resolve/pass_ports.h"
#include "graph/resolve/pass_stage.h"
#include "graph/resolve/views/view_rects.h"

namespace weft {
namespace {

class PassAttacher : PassStage<Attachments> {
 public:
    using PassStage::PassStage;

    void run() {
        for (uint32_t i = 0; i < bound_.uses.size(); ++i) {
            if (bound_.ports[i].color_output) add_color(i);
            if (bound_.ports[i].is_depth_port) add_depth(i);
        }
        std::ranges::sort(result_.colors, {}, &AttachmentDecl::location);
        const uint32_t limit = declared_.input.profile.max_color_attachments;
        if (result_.colors.size() > limit) {
            error(draft_.decl.loc, "W180",
                  "pass " + quote(draft_.decl.name) + " has " + std::to_string(result_.colors.size()) +
                      " colour outputs; the device allows at most " + std::to_string(limit),
                  "split the pass, or combine its outputs");
        }
        check_agreement();
        check_stencil();
        check_viewport();
        if (desc().view_target == ViewTarget::rects && !suspects_.passes[pass_]) find_rect();
        for (const ResolveDesc& resolve : desc().resolves) add_resolve(resolve);
    }

 private:
    void error(SourceLoc loc, const char* code, const std::string& message, const std::string& help) {
        add_help(report(loc, code, message), help);
    }

    std::array<float, 4> clear_value(const UseDecl& use) {
        const auto own = desc().clear_ports.find(use.port);
        if (own != desc().clear_ports.end()) return evaluator_.color(own->second);
        const ResourceDecl& resource = graph_.resources[use.resource];
        // The "clear" of a pass is a colour, so it applies to the colour attachments of the pass, and not to
        // its depth attachment.
        if (desc().clear && !(resource.aspects & aspect::kDepth)) return evaluator_.color(*desc().clear);
        // If no clear value is given, attachments are cleared to 0. For depth, 0 means infinitely far,
        // because depth is reversed.
        return resource.clear.value_or(std::array<float, 4>{0, 0, 0, 0});
    }

    void add_color(uint32_t index) {
        const UseDecl& use = bound_.uses[index];
        AttachmentDecl color;
        color.use = index;
        color.location = bound_.ports[index].color_output->location;
        color.blend = blend_of(desc(), use.port);
        color.clear = clear_value(use);
        const bool explicitly_cleared = desc().clear || desc().clear_ports.contains(use.port);
        color.covers = bound_.ports[index].rank == WriteRank::fresh && !explicitly_cleared;
        result_.colors.push_back(color);
        check_range(use);
    }

    void add_depth(uint32_t index) {
        AttachmentDecl depth;
        depth.use = index;
        depth.clear = clear_value(bound_.uses[index]);
        result_.depth = depth;
        check_range(bound_.uses[index]);
    }

    void check_stencil() {
        if (!desc().state.stencil_test || desc().depth || suspects_.passes[pass_]) return;
        error(draft_.decl.loc, "W182",
              "the state of pass " + quote(draft_.decl.name) +
                  " tests stencil, but the pass has no depth-stencil attachment",
              "add \"depth\" with an image whose format has stencil: \"d32f_s8\", \"d24_s8\", or the list of "
              "alternatives \"d32f_s8|d24_s8\"; or remove \"stencil\"");
    }

    // Checks the size and the position of the viewport. Let s be the side of the largest 2D image that the
    // device supports, in pixels. Width and height of the viewport must be at most s, and the coordinates of
    // its corners must be in the range [-2 s, 2 s - 1].
    void check_viewport() {
        if (!draft_.decl.state.viewport) return;
        const RectPx& view = *draft_.decl.state.viewport;
        const int64_t side = declared_.input.profile.max_image_2d_px;
        const auto fits = [&](int64_t place, int64_t extent) {
            return extent <= side && place >= -2 * side && place + extent <= 2 * side - 1;
        };
        if (fits(view.x, view.width) && fits(view.y, view.height)) return;
        error(draft_.decl.loc, "W119",
              "the viewport of pass " + quote(draft_.decl.name) + " is " + std::to_string(view.width) + "x" +
                  std::to_string(view.height) + " px at " + std::to_string(view.x) + ", " +
                  std::to_string(view.y),
              "the device allows " + std::to_string(side) + " px for each side, and positions from " +
                  std::to_string(-2 * side) + " to " + std::to_string(2 * side - 1));
    }

    void find_rect() {
        const std::optional<double> view = draft_.indices.at(kViewIndex);
        const ViewList& list = declared_.values.views.at(desc().view);
        Result<RectPx> rect =
            view_rect(list, static_cast<uint32_t>(*view), result_.render_extent, evaluator_);
        if (rect) {
            result_.rect = *rect;
            return;
        }
        if (rect.errors().empty()) return;
        const Diagnostic& fault = rect.errors().front();
        const SourceLoc loc = list.desc != nullptr && list.desc->rect ? list.desc->loc : desc().view_loc;
        error(loc, "W192", "pass " + quote(desc().name) + ": " + fault.message, fault.help.front());
    }

    void add_resolve(const ResolveDesc& resolve) {
        const auto port = std::ranges::find(bound_.ports, &resolve.target, &PortDraft::desc);
        // If the target of the resolve is not bound, bind() has already reported an error.
        if (port == bound_.ports.end()) return;
        const auto target = static_cast<uint32_t>(port - bound_.ports.begin());
        const auto color = std::ranges::find_if(result_.colors, [&](const AttachmentDecl& c) {
            return bound_.uses[c.use].port == resolve.output;
        });
        const std::string what = "output " + quote(resolve.output) + " of pass " + quote(draft_.decl.name);
        if (color == result_.colors.end()) {
            if (!suspects_.passes[pass_])
                error(resolve.output_loc, "W179", what + " is not a colour attachment",
                      "remove this output from \"resolve\": only colour attachments can be resolved");
            return;
        }
        if (color->resolve_use != kNoId)
            return error(resolve.output_loc, "W179", what + " is resolved twice",
                         "resolve the output once, and copy the result");
        color->resolve_use = target;
        check_range(bound_.uses[target]);
        check_resolve(bound_.uses[color->use], bound_.uses[target]);
    }

    void check_resolve(const UseDecl& from, const UseDecl& to) {
        const ResourceDecl& many = graph_.resources[from.resource];
        const ResourceDecl& one = graph_.resources[to.resource];
        if (suspects_.shapes[from.resource] || suspects_.shapes[to.resource]) return;
        const std::string what = "pass " + quote(draft_.decl.name) + " can't resolve " + quote(many.name) +
                                 " into " + quote(one.name) + ": ";
        if (one.kind == ResourceKind::buffer)
            return error(to.loc, "W179", what + "the target is a buffer", "name an image");
        if (many.samples == 1)
            return error(to.loc, "W179", what + quote(many.name) + " has only one sample per pixel",
                         "give this image \"samples\": 4, or write " + quote(one.name) + " directly");
        if (one.samples != 1)
            return error(to.loc, "W179", what + "both are multisampled",
                         "remove \"samples\" of " + quote(one.name));
        if (many.format != one.format)
            return error(to.loc, "W179", what + "their formats differ", "give both the same format");
        if (use_extent(graph_.resources, to) != result_.render_extent)
            error(to.loc, "W179",
                  what + "their sizes are " + extent_text(result_.render_extent) + " and " +
                      extent_text(use_extent(graph_.resources, to)),
                  "give both the same size, or select a mip of this size");
    }

    void check_range(const UseDecl& use) {
        const ResourceDecl& resource = graph_.resources[use.resource];
        if (resource.image_kind == ImageKind::d3)
            return error(use.loc, "W169",
                         "attachment " + quote(use.port) + " of pass " + quote(draft_.decl.name) +
                             " is the 3D image " + quote(resource.name),
                         "write the 3D image in a compute pass, or use an array image");
        if (use.range.mips == 1 && use.range.layers == std::max(draft_.views, 1u)) return;
        const std::string pick =
            resource.name + (use.range.mips > 1 ? ".mip(0)" : "") + (use.range.layers > 1 ? ".layer(0)" : "");
        error(use.loc, "W169",
              "attachment " + quote(use.port) + " of pass " + quote(draft_.decl.name) +
                  " must be one mip of one layer, but " + quote(range_of(resource, use.range)) + " has " +
                  std::to_string(use.range.mips) + " mips and " + std::to_string(use.range.layers) +
                  " layers",
              "select one mip and layer: " + quote(pick));
    }

    std::vector<uint32_t> attachment_uses() const {
        std::vector<uint32_t> uses;
        for (const AttachmentDecl& color : result_.colors) uses.push_back(color.use);
        if (result_.depth) uses.push_back(result_.depth->use);
        return uses;
    }

    void check_agreement() {
        const std::vector<uint32_t> uses = attachment_uses();
        if (uses.empty()) {
            if (suspects_.passes[pass_]) return;
            error(draft_.decl.loc, "W181",
                  "pass " + quote(draft_.decl.name) +
                      " has no attachment to draw to: no output variable of its fragment shader has the name "
                      "of a port in \"out\" of the pass, and the pass has no \"depth\"",
                  "declare an output variable in the fragment shader, for example \"layout(location = 0) out "
                  "vec4 color;\", and a port of the same name; or add \"depth\" to the pass");
            return;
        }
        const UseDecl& first = bound_.uses[uses.front()];
        result_.render_extent = use_extent(graph_.resources, first);
        for (const uint32_t index : uses) {
            const UseDecl& use = bound_.uses[index];
            if (suspects_.shapes[use.resource] || suspects_.shapes[first.resource]) continue;
            const Extent3D extent = use_extent(graph_.resources, use);
            if (extent != result_.render_extent) {
                error(use.loc, "W174",
                      "attachments of pass " + quote(draft_.decl.name) + " differ in size: " +
                          quote(first.port) + " is " + extent_text(result_.render_extent) + ", " +
                          quote(use.port) + " is " + extent_text(extent),
                      "give the attachments the same \"size\" and mip");
                return;
            }
            const uint32_t samples = graph_.resources[use.resource].samples;
            const uint32_t wanted = graph_.resources[first.resource].samples;
            if (samples != wanted) {
                error(use.loc, "W174",
                      "attachments of pass " + quote(draft_.decl.name) +
                          " differ in samples: " + quote(first.port) + " has " + std::to_string(wanted) +
                          ", " + quote(use.port) + " has " + std::to_string(samples),
                      "give the attachments the same \"samples\"");
                return;
            }
        }
    }
};

}  // namespace

Attachments attach(const Declared& declared, const VersionedGraph& graph, Reporter& reporter) {
    Attachments attachments{.passes = std::vector<PassAttachments>(graph.passes.size()),
                            .suspects = graph.suspects};
    for (PassId pass(0); pass < graph.passes.size(); ++pass) {
        const PassDraft& draft = declared.expansion.passes[pass];
        const bool draws = draft.decl.kind == PassKind::raster || draft.decl.kind == PassKind::fullscreen;
        if (draws && draft.shader) PassAttacher(declared, graph, pass, attachments, reporter).run();
    }
    return attachments;
}

}  // namespace weft
