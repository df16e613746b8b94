// How a session's graph is made ready, and how one takes over from another.
#include "shader/shader_memory.h"
#include "render/frame_data.h"
#include "render/gpu_scene.h"
#include "weft/check/check_plan.h"
#include "weft/check/check_transition.h"
#include "weft/compile.h"
#include "weft/render/import_catalog.h"
#include "weft/render/session.h"
#include "weft/report/memory_report.h"

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

// What stands between a plan and its objects.
Diagnostics faults_on(const vk::Device& device, const FramePlan& plan, const SessionInput& input) {
    Diagnostics faults = too_large(device, plan, input);
    return faults.empty() ? missing_features(device, plan) : faults;
}

}  // namespace

LoadInput Session::load_input(const Selection& selection, const ImportCatalog& imports) const {
    return {.path = selection.graph_path,
            .reader = input_.reader,
            .shader_root = input_.shader_root,
            .shader_cache = input_.shader_cache,
            .passes = passes_,
            .imports = imports,
            .profile = device_.profile(),
            .output_extent = selection.size,
            .params = selection.params,
            .observed = input_.observed,
            .shader_worker = input_.shader_worker,
            .limits = input_.limits,
            .graph_root = input_.graph_root,
            .tier = selection.tier,
            .debug = input_.debug};
}

StageMark Session::running() const {
    const std::lock_guard lock(marking_);
    return mark_;
}

Result<LoadedGraph> Session::load(const Selection& selection, const ImportCatalog& imports,
                                  Diagnostics& warnings) {
    LoadInput input = load_input(selection, imports);
    memory_->begin();
    input.memory = memory_.get();
    input.reader = [&](const std::string& path) {
        memory_->add_file(std::filesystem::absolute(path).lexically_normal());
        std::error_code error;
        if (std::filesystem::path real = std::filesystem::canonical(path, error); !error)
            memory_->add_file(std::move(real));  // of a link, what it leads to
        return input_.reader(path);
    };
    Result<LoadedGraph> loaded = load_graph(input, warnings);
    if (loaded) memory_->forget_unused();
    return loaded;
}

Preparation Session::prepare(const Selection& selection) {
    const std::lock_guard one_at_a_time(preparing_);
    Diagnostics warnings;
    Result<LoadedGraph> loaded = load(selection, resized(imports_, selection.size), warnings);
    std::set<std::filesystem::path> files = memory_->files();
    if (!loaded) return {loaded.take_errors(), std::move(warnings), std::move(files)};
    Result<Prepared> next = follow_with(selection, loaded->shaders, loaded->graph);
    if (next) next->loaded = std::move(*loaded);
    return {std::move(next), std::move(warnings), std::move(files)};
}

Result<Prepared> Session::follow_with(const Selection& selection, const ShaderCatalog& shaders,
                                      const ResolvedGraph& graph) {
    Result<FramePlan> plan = checked_plan(device_, graph, input_);
    if (!plan) return plan.take_errors();
    Diagnostics faults = faults_on(device_, *plan, input_);
    if (!faults.empty()) return faults;
    const StageMark now = running();
    Prepared next;
    next.selection = selection;
    next.follows = now.turn;
    next.mark = mark_of(*plan, shaders, selection.output);
    const bool same_structure = next.mark.structure_hash == now.structure_hash &&
                                next.mark.output == now.output && same_bindings(next.mark, now);
    next.rebuilt.shaders = static_cast<uint32_t>(shaders.size());
    next.rebuilt.changed_shaders = changed_programs(now, next.mark);
    next.rebuilt.plan = !same_structure;
    next.rebuilt.values = same_structure && next.mark.plan_hash != now.plan_hash;
    if (next.rebuilt.nothing()) return next;

    ImportCatalog imports = resized(imports_, selection.size);
    vk::ExecutorInput run;
    run.hooks.drop_barriers_of_position = position_of(*plan, input_.drop_barriers_before);
    run.plan = std::move(*plan);
    run.shaders = &shaders;
    run.passes = &passes_;
    run.draws = scene_.get();
    run.pipelines = &pipelines_;
    run.timestamps = input_.timestamps;
    run.imports = &imports;
    if (same_structure) {
        Result<std::unique_ptr<vk::Amendment>> amendment =
            vk::Executor::make_amendment(device_, std::move(run));
        if (!amendment) return amendment.take_errors();
        next.amendment = std::move(*amendment);
    } else if (Status made = make_stage(next, std::move(run), imports); !made) {
        return made.take_errors();
    }
    const vk::PipelineCounts counts =
        next.stage ? next.stage->executor->pipelines() : next.amendment->pipelines();
    next.rebuilt.pipelines = counts.all;
    next.rebuilt.made_pipelines = counts.made;
    if (std::this_thread::get_id() == drawing_thread_) pipelines_made_between_frames_ += counts.made;
    return next;
}

Status Session::make_stage(Prepared& next, vk::ExecutorInput run, ImportCatalog imports) const {
    const ResourceDecl& decl = imports.imports.at("backbuffer").resource;
    const VkImage own = next.selection.output;
    Result<vk::Image> output =
        own != VK_NULL_HANDLE ? vk::Image::adopt(device_, own, decl) : vk::Image::create(device_, decl);
    if (!output) return output.take_errors();
    run.bindings.images.emplace("backbuffer", &*output);
    for (const char* list : kDrawLists)
        run.bindings.buffers.emplace(commands_of(list), scene_->commands(list));
    Result<std::unique_ptr<vk::Executor>> executor = vk::Executor::create(device_, std::move(run));
    if (!executor) return executor.take_errors();
    next.stage = Stage{std::move(imports), std::move(*output), std::move(*executor)};
    return Unit{};
}

Result<bool> Session::swap_in(Prepared next) {
    if (next.follows != running().turn) return false;
    if (next.amendment) stage_.executor->amend(std::move(next.amendment));
    if (next.stage) {
        Status handed_over = hand_over_to(std::move(*next.stage));
        if (!handed_over) return handed_over.take_errors();
    }
    if (next.selection.size != selection_.size) {
        // Where a point was, the last frame knows in its own picture's terms.
        const glm::mat4 last_view_projection = view_.steady_view_projection;
        view_ = view_constants(input_.camera, glm::mat4(1), next.selection.size.width,
                               next.selection.size.height);
        view_.prev_view_projection = last_view_projection;
    }
    adopt(next);
    return true;
}

// Nothing has changed where this fails with errors of the checker.
Status Session::hand_over_to(Stage stage) {
    const FramePlan &old_plan = plan(), &new_plan = stage.executor->plan();
    TransitionPlan between = transition(old_plan, new_plan);
    if (input_.check_plan || kAlwaysCheck) {
        Diagnostics faults = check_transition(old_plan, new_plan, between);
        if (!faults.empty()) return faults;
    }
    vk::Predecessor predecessor;
    predecessor.images.push_back(std::move(stage_.output));
    predecessor.transition = std::move(between);
    predecessor.executor = std::move(stage_.executor);
    stage_ = std::move(stage);
    return stage_.executor->take_over(std::move(predecessor));
}

void Session::adopt(Prepared& next) {
    selection_ = std::move(next.selection);
    if (next.loaded) loaded_ = std::move(*next.loaded);
    sun_maps_ = sun_maps_of(plan());
    const std::lock_guard lock(marking_);
    const uint64_t turn = mark_.turn + 1;
    mark_ = std::move(next.mark);
    mark_.turn = turn;
}

Status Session::resize(Extent3D size, Diagnostics& warnings, VkImage output) {
    if (size == selection_.size) return Unit{};
    Selection selection = selection_;
    selection.size = size;
    selection.output = output;
    const ImportCatalog imports = resized(imports_, size);
    Result<ResolvedGraph> graph = resolve_again(loaded_, load_input(selection, imports), warnings);
    if (!graph) return graph.take_errors();
    Result<Prepared> next = follow_with(selection, loaded_.shaders, *graph);
    if (!next) return next.take_errors();
    // Only this thread swaps, so it still follows what runs.
    Result<bool> swapped = swap_in(std::move(*next));
    if (!swapped) return swapped.take_errors();
    loaded_.graph = std::move(*graph);
    return Unit{};
}

}  // namespace weft::render
