#include "render/session.h"

#include <cmath>

#include "check/check_plan.h"
#include "render/import_catalog.h"
#include "weft/compile.h"
#include "weft/light_list.h"

namespace weft::render {
namespace {

// What the ground below the horizon sends up: daylight on something of a quarter's albedo.
constexpr float kGroundAlbedo = 0.25f;

#ifdef NDEBUG
constexpr bool kAlwaysCheck = false;
#else
constexpr bool kAlwaysCheck = true;
#endif

uint32_t position_of(const FramePlan& plan, const std::string& pass) {
    for (uint32_t p = 0; p < plan.schedule.order.size(); ++p)
        if (plan.graph.passes[plan.schedule.order[p]].name == pass) return p;
    return kNoId;
}

// What the imports' objects will be: of all families where the device has queues of several, else of one.
void own_imports(const vk::Device& device, ImportCatalog& catalog) {
    for (auto& [name, import] : catalog.imports) {
        if (!import.resource.import) continue;
        import.resource.import->concurrent = !device.sharing_families().empty();
        import.resource.import->family = device.queue().family;
    }
}

Result<FramePlan> checked_plan(vk::Device& device, const ResolvedGraph& graph, const SessionInput& input) {
    CompileOptions options;
    options.queues = logical_queues(device.profile(), input.queues);
    options.granularity_bytes = device.profile().buffer_image_granularity_bytes;
    FramePlan plan = compile(graph, vk::query_memory_needs(device, graph), options);
    if (!input.check_plan && !kAlwaysCheck) return plan;
    Diagnostics faults = check_plan(plan);
    if (!faults.empty()) return faults;
    return plan;
}

// Draws say by their first instance what they draw, which indirect ones need a feature for.
Diagnostics missing_features(const vk::Device& device, const FramePlan& plan) {
    Diagnostics missing;
    if (device.optional().draw_indirect_first_instance) return missing;
    for (const PassId id : plan.schedule.order) {
        const PassDecl& pass = plan.graph.passes[id];
        if (pass.draw_commands_use == kNoId) continue;
        missing.push_back(plan.graph.sources.error(
            pass.loc, "V417",
            "pass \"" + pass.name + "\" draws indirectly; the device lacks drawIndirectFirstInstance"));
        missing.back().help = {"draw the list directly: \"draws\": [\"" + pass.draw_lists.front() + "\"]"};
    }
    return missing;
}

}  // namespace

Result<std::unique_ptr<Session>> Session::create(vk::Device& device, const scene::Scene& scene,
                                                 const SessionInput& input, Diagnostics& warnings) {
    std::unique_ptr<Session> session(new Session);
    session->imports_ = scene_imports(input.size, &scene);
    own_imports(device, session->imports_);
    session->passes_ = *input.passes;
    Result<LoadedGraph> loaded =
        load_graph({input.graph_path, input.reader, input.shader_root, input.shader_cache, session->passes_,
                    session->imports_, device.profile(), input.size, input.params, input.observed},
                   warnings);
    if (!loaded) return loaded.take_errors();
    session->loaded_ = std::move(*loaded);
    Result<FramePlan> plan = checked_plan(device, session->loaded_.graph, input);
    if (!plan) return plan.take_errors();
    Diagnostics missing = missing_features(device, *plan);
    if (!missing.empty()) return missing;

    Result<std::unique_ptr<GpuScene>> gpu = GpuScene::create(device, scene);
    if (!gpu) return gpu.take_errors();
    session->scene_ = std::move(*gpu);
    Result<vk::Image> output = vk::Image::create(device, session->imports_.imports.at("backbuffer").resource);
    if (!output) return output.take_errors();
    session->output_ = std::move(*output);
    session->lights_ = gpu_lights(scene);
    session->sky_zenith_ = scene.sky_zenith;
    session->sky_horizon_ = scene.sky_horizon;
    session->pre_exposure_ = std::exp2(input.exposure_ev);
    session->view_ = view_constants(input.camera, glm::mat4(1), input.size.width, input.size.height);
    session->view_.prev_view_projection = session->view_.view_projection;

    vk::ExecutorInput run;
    run.hooks.drop_barriers_of_position = position_of(*plan, input.drop_barriers_before);
    run.plan = std::move(*plan);
    run.shaders = &session->loaded_.shaders;
    run.passes = &session->passes_;
    run.imports = &session->imports_;
    run.bindings.images.emplace("backbuffer", &session->output_);
    for (const char* list : kDrawLists)
        run.bindings.buffers.emplace(commands_of(list), session->scene_->commands(list));
    run.draws = session->scene_.get();
    run.timestamps = input.timestamps;
    Result<std::unique_ptr<vk::Executor>> executor = vk::Executor::create(device, std::move(run));
    if (!executor) return executor.take_errors();
    session->executor_ = std::move(*executor);
    return session;
}

shared::FrameConstants Session::frame_constants(double time_s, double delta_time_s) const {
    shared::FrameConstants frame{};
    frame.sky_zenith = sky_zenith_;
    frame.sky_horizon = sky_horizon_;
    frame.sky_ground = sky_horizon_ * kGroundAlbedo;
    frame.light_count = static_cast<uint32_t>(lights_.size());
    frame.frame_index = static_cast<uint32_t>(frame_index_);
    frame.time_s = static_cast<float>(time_s);
    frame.delta_time_s = static_cast<float>(delta_time_s);
    frame.pre_exposure = pre_exposure_;
    frame.prev_pre_exposure = pre_exposure_;
    return frame;
}

Status Session::render_frame(double time_s, double delta_time_s) {
    Result<uint32_t> slot = executor_->begin_frame();
    if (!slot) return slot.take_errors();
    scene_->set_frame(*slot, frame_constants(time_s, delta_time_s), view_);
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
    return executor_->run(frame);
}

Status Session::finish() {
    return executor_->finish();
}

Result<vk::ReadbackData> Session::read_output() {
    return executor_->read_image(output_);
}

}  // namespace weft::render
