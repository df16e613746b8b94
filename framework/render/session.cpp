#include "weft/render/session.h"

#include <algorithm>
#include <cmath>

#include "shader/shader_memory.h"
#include "render/frame_data.h"
#include "render/gpu_scene.h"
#include "render/jitter.h"
#include "render/unsupported_report.h"
#include "scene/model/light_check.h"
#include "weft/light_list.h"
#include "weft/render/import_catalog.h"

namespace weft::render {
namespace {

// What the imports' objects will be: of all families where the device has queues of several, else of one.
void own_imports(const vk::Device& device, ImportCatalog& catalog) {
    for (auto& [name, import] : catalog.imports) {
        if (!import.resource.import) continue;
        import.resource.import->concurrent = !device.sharing_families().empty();
        import.resource.import->family = device.queue().family;
    }
}

}  // namespace

VkImageCreateInfo output_create_info(const vk::Device& device, Extent3D size) {
    VkImageCreateInfo info = vk::image_create_info(scene_imports(size).imports.at("backbuffer").resource);
    vk::share(info, vk::concurrent_sharing(device));
    return info;
}

Session::Session(vk::Device& device, const SessionInput& input)
    : device_(device),
      input_(input),
      passes_(*input.passes),
      memory_(std::make_unique<ShaderMemory>()),
      selection_{input.graph_path, input.tier, input.params, input.size, input.output},
      pre_exposure_(std::exp2(input.exposure_ev)) {
    view_ = view_constants(input.camera, glm::mat4(1), input.size.width, input.size.height);
    view_.prev_view_projection = view_.steady_view_projection;
}

Session::~Session() = default;

Result<std::unique_ptr<Session>> Session::create(vk::Device& device, const scene::Scene& scene,
                                                 const SessionInput& input, Diagnostics& warnings,
                                                 std::set<std::filesystem::path>* files) {
    return create(device, scene, nullptr, input, warnings, files);
}

Result<std::unique_ptr<Session>> Session::create(vk::Device& device, scene::Scene&& scene,
                                                 const SessionInput& input, Diagnostics& warnings,
                                                 std::set<std::filesystem::path>* files) {
    return create(device, scene, &scene, input, warnings, files);
}

Result<std::unique_ptr<Session>> Session::create(vk::Device& device, const scene::Scene& scene,
                                                 scene::Scene* owned, const SessionInput& input,
                                                 Diagnostics& warnings,
                                                 std::set<std::filesystem::path>* files) {
    std::unique_ptr<Session> session(new Session(device, input));
    session->imports_ = scene_imports(input.size, &scene);
    own_imports(device, session->imports_);
    Result<LoadedGraph> loaded = session->load(session->selection_, session->imports_, warnings);
    if (files != nullptr) files->merge(std::set<std::filesystem::path>(session->memory_->files()));
    if (!loaded) return loaded.take_errors();
    Result<std::unique_ptr<GpuScene>> gpu = GpuScene::create(device, scene, owned);
    if (!gpu) return gpu.take_errors();
    session->scene_ = std::move(*gpu);
    session->scene_lights_ = scene.lights;
    session->lights_move_ = std::ranges::any_of(
        scene.lights, [](const scene::Light& light) { return light.path.turns_per_s != 0; });
    session->lights_ = gpu_lights(scene.lights, 0, scene.light_functions.size());
    session->light_functions_ = scene.light_functions.size();
    session->scene_constants_ = scene_constants(scene);
    session->scene_bounds_ = scene::world_bounds(scene);
    Result<Prepared> first = session->follow_with(session->selection_, loaded->shaders, loaded->graph);
    if (!first) return first.take_errors();
    first->loaded = std::move(*loaded);
    session->stage_ = std::move(*first->stage);
    session->adopt(*first);
    session->first_files_ = session->memory_->files();
    session->pipelines_made_between_frames_ = 0;
    for (Diagnostic& warning : scene::light_warnings(scene)) warnings.push_back(std::move(warning));
    for (Diagnostic& warning : report_unsupported(session->plan(), scene))
        warnings.push_back(std::move(warning));
    return session;
}

shared::FrameConstants Session::frame_constants(double time_s, double delta_time_s) const {
    shared::FrameConstants frame = scene_constants_;
    frame.light_count = static_cast<uint32_t>(lights_.size());
    const auto directional = [](const shared::Light& light) {
        return light.type == shared::kLightDirectional;
    };
    frame.directional_count = static_cast<uint32_t>(std::ranges::count_if(lights_, directional));
    const auto first_other = std::ranges::find_if_not(lights_, is_plain);
    frame.plain_count = static_cast<uint32_t>(first_other - lights_.begin());
    frame.frame_index = static_cast<uint32_t>(frame_index_);
    frame.time_s = static_cast<float>(time_s);
    frame.delta_time_s = static_cast<float>(delta_time_s);
    frame.pre_exposure = pre_exposure_;
    frame.prev_pre_exposure = pre_exposure_;
    return frame;
}

// Directional lights come first.
SunCascades Session::find_sun() const {
    if (sun_maps_.count == 0 || lights_.empty() || lights_[0].type != shared::kLightDirectional) return {};
    const float aspect = view_.viewport_px.x / view_.viewport_px.y;
    return sun_cascades(input_.camera, aspect, {-lights_[0].direction, scene_bounds_}, sun_maps_);
}

Status Session::render_frame(double time_s, double delta_time_s) {
    Result<uint32_t> slot = stage_.executor->begin_frame();
    if (!slot) return slot.take_errors();
    if (lights_move_) lights_ = gpu_lights(scene_lights_, time_s, light_functions_);
    view_ = view_constants(input_.camera, view_.prev_view_projection, selection_.size.width,
                           selection_.size.height, jitter_px(frame_index_, loaded_.desc.jitter));
    sun_ = find_sun();
    scene_->set_frame(*slot, frame_constants(time_s, delta_time_s), view_, sun_);
    const LightList lights{lights_};
    HostInputs host;
    host.set("lights", lights);
    vk::FrameInput frame;
    frame.frame_index = frame_index_++;
    frame.time_s = time_s;
    frame.delta_time_s = delta_time_s;
    frame.pre_exposure = pre_exposure_;
    frame.prev_pre_exposure = pre_exposure_;
    frame.host = &host;
    Status done = stage_.executor->run(frame);
    view_.prev_view_projection = view_.steady_view_projection;
    return done;
}

Status Session::finish() {
    return stage_.executor->finish();
}

Result<vk::ReadbackData> Session::read_output() {
    if (!has_output()) {
        Diagnostic d;
        d.code = "W184";
        d.message = "the graph has no output";
        d.help = {"let it import one, \"imports\": { \"backbuffer\": \"output\" }, and let a pass write it",
                  "or look at one of its resources: --resource NAME"};
        return d;
    }
    return stage_.executor->read_image(stage_.output);
}

}  // namespace weft::render
