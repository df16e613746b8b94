// Purpose: draw lists of the program, so that the raster passes of a graph draw meshes that are in no
// scene::Scene. The program records the draws itself, with its own vertex buffers, descriptor sets and, if it
// wants, pipelines. Units: metres.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "weft/imports.h"
#include "weft/scene/scene.h"
#include "weft/vulkan/draw_source.h"

namespace weft::render {

// The view from which a list is drawn.
struct DrawView {
    glm::mat4 view_projection{1};  // From world space to clip space, with the jitter of the camera.
    // True: the picture is a mirror image, so front faces are clockwise.
    bool mirrored = false;
    // If the draws draw several views at once (DrawContext::views): the matrices of all of them, of which
    // `view_projection` is the first. Otherwise empty.
    std::span<const glm::mat4> all_view_projections;
};

class DrawList {
 public:
    virtual ~DrawList() = default;
    // Records to `draw.commands`, within a rendering scope: all draws of the list that have the variant
    // `draw.variant`. The pipeline of the pass and its sets 0 and 1 are bound. Viewport, scissor, cull mode
    // and front face are dynamic state; viewport and scissor are set. The list binds its vertex buffers in
    // the order of the streams in the vertex format. It binds each of the sets 2 and 3 that the pipeline
    // layout `draw.layout` has. It sets the front face, and the cull mode if `draw.cull` is `material`. It
    // may bind a pipeline of its own for `draw.targets`. Returns the number of draws that it did not record,
    // because they are outside of the frustum of the view.
    virtual uint32_t record(const vk::DrawContext& draw, const DrawView& view) const = 0;
    // Returns a number that changes whenever the draws change; nullopt if they may change in every frame.
    [[nodiscard]] virtual std::optional<uint64_t> version() const { return std::nullopt; }
    // Returns a box in world space that contains all draws. The shadow maps of the sun cover it. nullopt: the
    // draws may be anywhere.
    [[nodiscard]] virtual std::optional<scene::Bounds> bounds() const { return std::nullopt; }
    // Returns the number of draws, for messages about slow frames.
    [[nodiscard]] virtual uint64_t count() const { return 0; }
};

struct OwnDrawList {
    const DrawList* list = nullptr;  // Must outlive the session.
    VertexFormat vertex_format;
    // The pipelines of each pass that draws the list: one for each variant.
    std::vector<DrawVariant> variants = {DrawVariant{}};
};

// A descriptor set of the program in the pipeline layouts of passes that draw lists: set 2 or 3.
struct OwnDrawSet {
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;  // Must outlive the session.
    // The bindings of the layout. `OfferedBinding::set` is the number of the set.
    std::vector<OfferedBinding> bindings;
};

using OwnDrawLists = std::map<std::string, OwnDrawList, std::less<>>;
using OwnDrawSets = std::map<uint32_t, OwnDrawSet>;

}  // namespace weft::render
