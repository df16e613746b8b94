#include "render/session.h"

#include <algorithm>
#include <cmath>

#include "check/check_plan.h"
#include "check/check_transition.h"
#include "graph/memory_report.h"
#include "render/frame_data.h"
#include "render/gpu_scene.h"
#include "render/import_catalog.h"
#include "render/jitter.h"
#include "render/left_out.h"
#include "weft/compile.h"
#include "weft/light_list.h"

namespace weft::render {
namespace {

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

ImportCatalog resized(ImportCatalog catalog, Extent3D size) {
    catalog.imports.at("backbuffer").resource.extent = size;
    return catalog;
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

// Before anything of it is allocated.
Diagnostics too_large(const vk::Device& device, const FramePlan& plan, const SessionInput& input) {
    Diagnostics faults = budget_faults(plan, input.limits.graph, input.graph_path);
    for (Diagnostic& fault : memory_faults(plan, device.profile(), input.graph_path)) {
        fault.severity = Severity::error;
        fault.code = "W143";
        faults.push_back(std::move(fault));
    }
    return faults;
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

VkImageCreateInfo output_create_info(const vk::Device& device, Extent3D size) {
    VkImageCreateInfo info = vk::image_create_info(scene_imports(size).imports.at("backbuffer").resource);
    vk::share(info, vk::concurrent_sharing(device));
    return info;
}

Session::Session(vk::Device& device, const SessionInput& input)
    : device_(device), input_(input), passes_(*input.passes), pre_exposure_(std::exp2(input.exposure_ev)) {
    input_.passes = &passes_;
    view_ = view_constants(input.camera, glm::mat4(1), input.size.width, input.size.height);
    view_.prev_view_projection = view_.steady_view_projection;
}

LoadInput Session::load_input(const ImportCatalog& imports, Extent3D size) const {
    return {.path = input_.graph_path,
            .reader = input_.reader,
            .shader_root = input_.shader_root,
            .shader_cache = input_.shader_cache,
            .passes = passes_,
            .imports = imports,
            .profile = device_.profile(),
            .output_extent = size,
            .params = input_.params,
            .observed = input_.observed,
            .shader_worker = input_.shader_worker,
            .limits = input_.limits,
            .graph_root = input_.graph_root,
            .tier = input_.tier};
}

Session::~Session() = default;

Result<Session::Stage> Session::make_stage(ImportCatalog imports, const ResolvedGraph& graph, VkImage own) {
    Result<FramePlan> plan = checked_plan(device_, graph, input_);
    if (!plan) return plan.take_errors();
    Diagnostics faults = too_large(device_, *plan, input_);
    if (!faults.empty()) return faults;
    Diagnostics missing = missing_features(device_, *plan);
    if (!missing.empty()) return missing;
    const ResourceDecl& decl = imports.imports.at("backbuffer").resource;
    Result<vk::Image> output =
        own != VK_NULL_HANDLE ? vk::Image::adopt(device_, own, decl) : vk::Image::create(device_, decl);
    if (!output) return output.take_errors();
    vk::ExecutorInput run;
    run.hooks.drop_barriers_of_position = position_of(*plan, input_.drop_barriers_before);
    run.plan = std::move(*plan);
    run.shaders = &loaded_.shaders;
    run.passes = &passes_;
    run.imports = &imports;
    run.bindings.images.emplace("backbuffer", &*output);
    for (const char* list : kDrawLists)
        run.bindings.buffers.emplace(commands_of(list), scene_->commands(list));
    run.draws = scene_.get();
    run.timestamps = input_.timestamps;
    Result<std::unique_ptr<vk::Executor>> executor = vk::Executor::create(device_, std::move(run));
    if (!executor) return executor.take_errors();
    return Stage{std::move(imports), std::move(*output), std::move(*executor)};
}

Result<std::unique_ptr<Session>> Session::create(vk::Device& device, const scene::Scene& scene,
                                                 const SessionInput& input, Diagnostics& warnings) {
    std::unique_ptr<Session> session(new Session(device, input));
    ImportCatalog imports = scene_imports(input.size, &scene);
    own_imports(device, imports);
    Result<LoadedGraph> loaded = load_graph(session->load_input(imports, input.size), warnings);
    if (!loaded) return loaded.take_errors();
    session->loaded_ = std::move(*loaded);
    Result<std::unique_ptr<GpuScene>> gpu = GpuScene::create(device, scene);
    if (!gpu) return gpu.take_errors();
    session->scene_ = std::move(*gpu);
    session->scene_lights_ = scene.lights;
    session->lights_move_ = std::ranges::any_of(
        scene.lights, [](const scene::Light& light) { return light.path.turns_per_s != 0; });
    session->lights_ = gpu_lights(scene.lights, 0);
    session->scene_constants_ = scene_constants(scene);
    Result<Stage> stage = session->make_stage(std::move(imports), session->loaded_.graph, input.output);
    if (!stage) return stage.take_errors();
    session->stage_ = std::move(*stage);
    for (Diagnostic& warning : left_out_by(session->plan(), scene)) warnings.push_back(std::move(warning));
    return session;
}

Status Session::resize(Extent3D size, Diagnostics& warnings, VkImage output) {
    if (size == input_.size) return Unit{};
    ImportCatalog imports = resized(stage_.imports, size);
    Result<ResolvedGraph> graph = resolve_again(loaded_, load_input(imports, size), warnings);
    if (!graph) return graph.take_errors();
    Result<Stage> stage = make_stage(std::move(imports), *graph, output);
    if (!stage) return stage.take_errors();
    const FramePlan &old_plan = plan(), &new_plan = stage->executor->plan();
    TransitionPlan between = transition(old_plan, new_plan);
    if (input_.check_plan || kAlwaysCheck) {
        Diagnostics faults = check_transition(old_plan, new_plan, between);
        if (!faults.empty()) return faults;
    }
    vk::Predecessor predecessor;
    predecessor.images.push_back(std::move(stage_.output));
    predecessor.transition = std::move(between);
    predecessor.executor = std::move(stage_.executor);
    stage_ = std::move(*stage);
    loaded_.graph = std::move(*graph);
    input_.size = size;
    // Where a point was, the last frame knows in its own picture's terms.
    const glm::mat4 last_view_projection = view_.steady_view_projection;
    view_ = view_constants(input_.camera, glm::mat4(1), size.width, size.height);
    view_.prev_view_projection = last_view_projection;
    return stage_.executor->take_over(std::move(predecessor));
}

shared::FrameConstants Session::frame_constants(double time_s, double delta_time_s) const {
    shared::FrameConstants frame = scene_constants_;
    frame.light_count = static_cast<uint32_t>(lights_.size());
    frame.frame_index = static_cast<uint32_t>(frame_index_);
    frame.time_s = static_cast<float>(time_s);
    frame.delta_time_s = static_cast<float>(delta_time_s);
    frame.pre_exposure = pre_exposure_;
    frame.prev_pre_exposure = pre_exposure_;
    return frame;
}

Status Session::render_frame(double time_s, double delta_time_s) {
    Result<uint32_t> slot = stage_.executor->begin_frame();
    if (!slot) return slot.take_errors();
    if (lights_move_) lights_ = gpu_lights(scene_lights_, time_s);
    view_ = view_constants(input_.camera, view_.prev_view_projection, input_.size.width, input_.size.height,
                           jitter_px(frame_index_, loaded_.desc.jitter));
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
    Status done = stage_.executor->run(frame);
    view_.prev_view_projection = view_.steady_view_projection;
    return done;
}

Status Session::finish() {
    return stage_.executor->finish();
}

Result<vk::ReadbackData> Session::read_output() {
    return stage_.executor->read_image(stage_.output);
}

}  // namespace weft::render
