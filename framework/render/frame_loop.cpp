#include "render/frame_loop.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "graph/diagnostics/make_error.h"
#include "render/frame_data.h"
#include "render/jitter.h"
#include "vulkan/device/to_vk.h"
#include "weft/check/check_transition.h"
#include "weft/compile.h"
#include "weft/light_list.h"
#include "weft/render/import_catalog.h"
#include "weft/vulkan/native.h"

namespace weft::render {
namespace {

// Returns all members that describe the image itself.
ExportedResource exported_image(const vk::Image& image, const ResourceDecl& decl) {
    const vk::NativeImage native = vk::native(image);
    return {.image = native.image,
            .view = native.view,
            .format = native.format,
            .extent = native.extent,
            .mips = decl.mips,
            .layers = decl.layers};
}

}  // namespace

FrameLoop::FrameLoop(RenderStage stage, Extent3D size, uint32_t jitter_length) : stage_(std::move(stage)) {
    set_graph(size, jitter_length);
}

void FrameLoop::set_graph(Extent3D size, uint32_t jitter_length) {
    size_ = size;
    jitter_length_ = jitter_length;
    sun_maps_ = sun_maps_of(plan());
    further_sun_sizes_ = further_sun_sizes(plan());
    lamp_maps_ = drawn_lamp_maps(plan());
    views_.set_plan(plan());
}

// Returns the view constants of this frame. The first frame and a frame after a cut (a sudden change of the
// camera, `cut`) have no usable previous view. Such a frame uses its own view as the previous view.
shared::ViewConstants FrameLoop::find_view(const scene::Camera& camera, bool cut) const {
    const glm::uvec2 output_px(size_.width, size_.height);
    // jitter_px() counts in pixels of the area in which passes draw the view of the camera. The factor
    // converts its result to pixels of the output.
    const glm::vec2 area_px = views_.camera_px(plan().graph, output_px);
    const glm::vec2 jitter = jitter_px(frame_index_, jitter_length_) * (glm::vec2(output_px) / area_px);
    shared::ViewConstants view =
        view_constants(camera, view_.steady_view_projection, size_.width, size_.height, jitter);
    view.mip_bias = mip_bias(jitter_length_);
    if (frame_index_ == 0 || cut) view.prev_view_projection = view.steady_view_projection;
    return view;
}

bool FrameLoop::takes_turns(std::string_view import) const {
    return std::ranges::any_of(plan().graph.groups,
                               [&](const GroupDecl& group) { return group.turns == import; });
}

Status FrameLoop::render(const FrameInput& input, const LiveInputs& live, DrawnScene& scene, Kind kind) {
    // The input is checked before begin_frame(): after it, only errors of Vulkan may end the frame early.
    if (Status given = views_.check(input.views); !given) return given;
    if (Status given = scene.check(input); !given) return given;
    Result<uint32_t> slot = stage_.executor->begin_frame();
    if (!slot) return slot.take_errors();
    std::erase_if(retired_, [&](const Retired& old) { return old.until <= frame_index_; });
    scene.gpu().parts().drop_retired(frame_index_);
    if (input.fill_slot) input.fill_slot(*slot);
    vk::FrameInput frame;
    frame.frame_index = frame_index_;
    frame.time_s = input.time_s;
    frame.delta_time_s = input.delta_time_s;
    frame.pre_exposure = std::exp2(input.exposure_ev);
    frame.prev_pre_exposure = frame_index_ == 0 ? frame.pre_exposure : pre_exposure_;
    const bool cut = input.camera_cut || hides_history_;
    frame.hides_history = cut;
    hides_history_ = kind == Kind::warm_up;
    frame.prepares_units = kind == Kind::warm_up;
    pre_exposure_ = frame.pre_exposure;
    scene.begin_frame(*slot, input);
    const scene::Camera camera = scene.placed(input.camera);
    views_.set_scales(plan().graph, live.scales);
    view_ = find_view(camera, cut);
    sun_ = scene.find_sun(camera, view_.viewport_px.x / view_.viewport_px.y, sun_maps_);
    further_suns_ = scene.find_further_suns(further_sun_sizes_);
    lamp_shadows_.update(scene.lights(), view_, lamp_maps_);
    shared::FrameConstants constants = scene.frame_constants();
    if (input.sky) set_sky(*input.sky, constants);
    constants.unshadowed_count = lamp_shadows_.count_unshadowed();
    constants.frame_index = static_cast<uint32_t>(frame_index_);
    if (kind == Kind::normal) ++frame_index_;
    constants.time_s = static_cast<float>(input.time_s);
    constants.delta_time_s = static_cast<float>(input.delta_time_s);
    constants.pre_exposure = frame.pre_exposure;
    constants.prev_pre_exposure = frame.prev_pre_exposure;
    views_.update(
        {view_, sun_, lamp_shadows_.ordered(), input.views, further_suns_, scene.gpu().probes().faces(),
         scene.gpu().probes().reflection_faces(), lamp_shadows_.views()},
        plan().graph);
    if (Status set = scene.gpu().set_frame(*slot, constants, sun_.constants, further_suns_.constants,
                                           views_.views(), views_.united_views());
        !set)
        return set;
    const LightList lights{std::as_bytes(std::span(lamp_shadows_.ordered()))};
    HostInputs host = input.host != nullptr ? *input.host : HostInputs{};
    host.set("lights", lights);
    frame.host = &host;
    frame.turns = input.turns;
    const auto choose = [&](const char* import, ProbeTurns& turns) {
        if (takes_turns(import) && !frame.turns.contains(import) && turns.size() > 0)
            frame.turns.emplace(import, turns.next(view_.eye));
    };
    choose(kProbeTurns, scene.probe_turns());
    choose(kReflectionTurns, scene.reflection_turns());
    frame.scales = live.scales;
    frame.switches = &live.switches;
    frame.submit = input.submit;
    scene.gpu().add_versions(frame.import_versions);
    // The textures of tables never change, so the version of each table is always 0.
    for (const std::string& table : stage_.tables) frame.import_versions.emplace(table, 0);
    // The files of the table "pictures" have the names "pictures[0]" and so on. Their hashes are combined
    // into the version of the table.
    for (const auto& [name, file] : stage_.files) {
        uint64_t& version = frame.import_versions[name.substr(0, name.find('['))];
        version = version * 31 + file.hash();
    }
    for (const auto& [name, version] : input.import_versions) frame.import_versions.emplace(name, version);
    return stage_.executor->run(frame);
}

std::optional<ExportedResource> FrameLoop::exported(std::string_view name) const {
    const ResourceId id = find_resource(plan().graph, name);
    if (id == kNoId) return std::nullopt;
    const ResourceDecl& decl = plan().graph.resources[id];
    const bool kept = decl.between.has_value();
    // A resource with history has several copies in memory, which rotate from frame to frame. last_copy()
    // returns the copy that has the content of the last frame.
    const ResourceId copy = kept ? stage_.executor->last_copy(id) : id;
    const auto found = stage_.exports.find(plan().graph.resources[copy].name);
    const VkBuffer kept_buffer = kept ? stage_.executor->native(copy).buffer : VK_NULL_HANDLE;
    if (found == stage_.exports.end() && kept_buffer == VK_NULL_HANDLE) return std::nullopt;
    const AccessState& state = kept ? *decl.between : decl.import->exit;
    ExportedResource out;
    if (decl.kind == ResourceKind::image) out = exported_image(found->second.image, decl);
    out.layout = vk::to_vk(state.layout);
    out.stages = vk::stages_to_vk(state.stages);
    out.access = vk::access_to_vk(state.access);
    if (decl.kind == ResourceKind::buffer) {
        out.buffer = kept ? kept_buffer : found->second.buffer.handle();
        out.size_bytes = decl.size_bytes;
    }
    return out;
}

Result<vk::ReadbackData> FrameLoop::read_output() {
    if (!has_output()) {
        return make_error(
            "W184", "the graph has no output, so there is no picture",
            {"import an output, \"imports\": { \"backbuffer\": \"output\" }, and let a pass write it",
             "or write a resource of the graph instead: --resource NAME"});
    }
    if (const Layout layout = plan().graph.resources[plan().graph.output].import->exit.layout;
        layout != Layout::transfer_src) {
        return make_error(
            "V426",
            "the output has the layout " + layout_text(layout) + " after the frame, so Weft cannot read it",
            {"give the output the final layout transfer_src (OutputFormat::final_layout), or read the image "
             "with commands of your own"});
    }
    return stage_.executor->read_image(stage_.output);
}

Status FrameLoop::take_over(RenderStage stage, bool check) {
    const FramePlan &old_plan = plan(), &new_plan = stage.executor->plan();
    TransitionPlan between = transition(old_plan, new_plan);
    if (check) {
        Diagnostics faults = check_transition(old_plan, new_plan, between);
        if (!faults.empty()) return faults;
    }
    if (Status uploaded = upload_files(stage.files); !uploaded) return uploaded;
    // When kFramesInFlight further frames have begun, the GPU no longer uses the old objects.
    retired_.push_back({std::move(stage_.files), std::move(stage_.exports), std::move(stage_.own_images),
                        frame_index_ + vk::kFramesInFlight});
    vk::Predecessor predecessor;
    predecessor.images.push_back(std::move(stage_.output));
    predecessor.transition = std::move(between);
    predecessor.executor = std::move(stage_.executor);
    stage_ = std::move(stage);
    return stage_.executor->take_over(std::move(predecessor));
}

}  // namespace weft::render
