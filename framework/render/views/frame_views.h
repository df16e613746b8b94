// Purpose: the views that the passes of a plan use in a frame, with their constants for shaders. The matrices
// come from the camera, the sun, the lamps, the program, or from other views. Errors: W193 (the program gives
// too few views).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "graph/live/live_frame.h"
#include "render/views/further_suns.h"
#include "render/views/lamp_shadows.h"
#include "render/views/sun_cascades.h"
#include "render/views/view_matrices.h"
#include "weft/plan.h"
#include "weft/result.h"

namespace weft::render {

// Name of the list with the views of the scene's lamps.
inline constexpr const char* kLampViews = "lampFaces";
// Name of the list with the views of the faces of the irradiance probes.
inline constexpr const char* kProbeFaceViews = "probeFaces";
// Name of the list with the views of the faces of the reflection probes.
inline constexpr const char* kReflectionFaceViews = "reflectionFaces";

// The names of the views that one pass with multiview draws, as in PassDecl::views.
using ViewNames = std::vector<std::string>;

struct FrameView {
    std::string name;  // "camera", "sun(1)" and so on.
    shared::ViewConstants constants{};
    bool mirrored = false;  // True if the picture is a mirror image.
    // If not 0: as long as this number stays the same, neither the constants nor the names of the views
    // change.
    uint64_t fixed = 0;
};

// Returns the name of a view for passes with this area; see DrawSource::frame_set_of_area().
[[nodiscard]] std::string area_view(std::string_view view, const LiveArea& area);

// The inputs from which the views of a frame are computed.
struct ViewSources {
    const shared::ViewConstants& camera;
    const SunCascades& sun;
    std::span<const shared::Light> lights;
    const ViewLists& program;
    const FurtherSunMaps& further_suns;
    std::span<const shared::ViewConstants> probe_faces;       // The views of kProbeFaceViews.
    std::span<const shared::ViewConstants> reflection_faces;  // The views of kReflectionFaceViews.
    std::span<const shared::ViewConstants> lamp_shadows;      // The views of kLampShadowViews.
};

class FrameViews {
 public:
    // Finds the views that the scheduled passes of a plan use, and the size at which passes draw each view.
    // Leaves out views that the GPU reads from buffers.
    void set_plan(const FramePlan& plan);
    // Returns an error W193 if the program gives fewer views of one of its lists than the plan uses.
    [[nodiscard]] Status check(const ViewLists& program) const;
    // Computes the live sizes of the plan (sizes that change with scales while the plan runs) for the next
    // frame. Call it before camera_px() and update().
    void set_scales(const ResolvedGraph& graph, const Scales& scales);
    // Returns the size in pixels at which raster passes draw the view of the camera: the size of the area if
    // they draw into an image with a live size, else `output_px`. The jitter of the camera moves the picture
    // by fractions of these pixels.
    [[nodiscard]] glm::uvec2 camera_px(const ResolvedGraph& graph, glm::uvec2 output_px) const;
    // Computes all views of the next frame. check() must have accepted the lists of the program.
    void update(const ViewSources& sources, const ResolvedGraph& graph);
    // Returns the views of the frame. The first is the camera. The views for passes with an area follow all
    // other views.
    [[nodiscard]] const std::vector<FrameView>& views() const { return views_; }
    // Returns the views of each pass with multiview. Passes with the same views have one entry.
    [[nodiscard]] const std::vector<ViewNames>& united_views() const { return united_views_; }

 private:
    struct Frame {
        const ViewSources& sources;
        std::vector<ViewInput> lamps;
    };
    // Returns true if the constants of the view do not change while the plan runs.
    [[nodiscard]] bool is_fixed(const std::string& view) const;
    // Returns true if the GPU reads the view from a buffer.
    [[nodiscard]] bool is_in_buffer(const std::string& view) const;
    void add_area_views(const FramePlan& plan);
    // Returns the constants of a view, but without its own size and previous matrix.
    [[nodiscard]] shared::ViewConstants make(const Frame& frame, const std::string& list,
                                             uint32_t index) const;
    [[nodiscard]] shared::ViewConstants make_given(const Frame& frame, const ViewListDecl& list,
                                                   uint32_t index) const;

    std::vector<ViewListDecl> lists_;
    uint64_t plans_ = 0;      // Number of calls of set_plan().
    bool has_fixed_ = false;  // True if the constants of the fixed views have been computed.
    std::vector<FrameView> views_;
    std::vector<ViewNames> united_views_;
    // The size of each view in pixels; 0 if no raster or fullscreen pass draws it.
    std::vector<glm::uvec2> sizes_px_;
    // A view for passes that draw only into an area of an image. It is a copy of a view in views_, with
    // another viewport.
    struct AreaView {
        uint32_t view = 0;  // Index into views_ of the view that is copied.
        LiveArea area;
    };
    std::vector<AreaView> area_views_;  // In views_, these views follow all other views.
    // The largest area in which raster passes draw the view of the camera.
    LiveArea camera_area_;
    std::vector<LiveNumber> live_;  // The values of ResolvedGraph::live_values in this frame.
    // The matrices view_projection of the previous frame, without jitter, by the name of the view.
    std::map<std::string, glm::mat4> before_;
};

}  // namespace weft::render
