#include "render/stage_maker.h"

#include "render/gpu_scene.h"
#include "render/imports/output_import.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"
#include "weft/render/import_catalog.h"
#include "weft/report/memory_report.h"
#include "weft/transition.h"

namespace weft::render {
namespace {

uint32_t position_of(const FramePlan& plan, const std::string& pass) {
    for (Position p(0); p < plan.schedule.order.size(); ++p)
        if (plan.graph.passes[plan.schedule.order[p]].name == pass) return p;
    return kNoId;
}

// Returns an error for each limit of the settings that the plan exceeds, and for each memory heap of the
// device that is too small for the plan.
Diagnostics find_excess(const vk::Device& device, const FramePlan& plan, const GraphLimits& limits,
                        const std::string& path) {
    Diagnostics faults = budget_faults(plan, limits, path);
    for (Diagnostic& fault : memory_faults(plan, device.profile(), path)) {
        fault.severity = Severity::error;
        fault.code = "W143";
        faults.push_back(std::move(fault));
    }
    return faults;
}

// Returns an error for each pass that draws indirectly, if the device lacks drawIndirectFirstInstance.
// Indirect draws need this feature, because firstInstance in a draw command is the index of the object.
Diagnostics find_missing_features(const vk::Device& device, const FramePlan& plan) {
    Diagnostics missing;
    if (device.optional().draw_indirect_first_instance) return missing;
    for (const PassId id : plan.schedule.order) {
        const PassDecl& pass = plan.graph.passes[id];
        if (pass.draw_commands_use == kNoId || pass.draws_without_list()) continue;
        missing.push_back(plan.graph.sources.error(
            pass.loc, "V417",
            "pass \"" + pass.name + "\" draws indirectly, but the device lacks drawIndirectFirstInstance"));
        missing.back().help = {"draw the list without indirect commands: \"draws\": [\"" +
                               pass.draw_lists.front() + "\"]"};
    }
    return missing;
}

// Makes the views of exported images that keep their content.
Status view_kept_exports(vk::Device& device, RenderStage& stage) {
    const std::vector<ResourceDecl>& resources = stage.executor->plan().graph.resources;
    for (ResourceId id(0); id < resources.size(); ++id) {
        const ResourceDecl& decl = resources[id];
        if (decl.ring == kNoId || !resources[decl.ring].between) continue;
        const VkImage image = stage.executor->native(id).image;
        if (image == VK_NULL_HANDLE) continue;
        Result<vk::Image> viewed = vk::Image::adopt(device, image, decl);
        if (!viewed) return viewed.take_errors();
        stage.exports[decl.name].image = std::move(*viewed);
    }
    return Unit{};
}

// Returns the names of the resources in `shared` for which the graph declares the same memory.
std::vector<std::string> find_retainable(const ResolvedGraph& graph,
                                         const std::vector<ResourceDecl>& shared) {
    std::vector<std::string> names;
    for (const ResourceDecl& decl : shared) {
        const ResourceId id = find_resource(graph, decl.name);
        if (id != kNoId && shares_memory(decl, graph.resources[id])) names.push_back(decl.name);
    }
    return names;
}

Rebuilt compare(const StageFingerprint& from, const StageFingerprint& to) {
    const bool same_plan = can_amend(from, to);
    Rebuilt rebuilt;
    rebuilt.shaders = static_cast<uint32_t>(to.programs.size());
    rebuilt.changed_shaders = count_changed_programs(from, to);
    rebuilt.plan = !same_plan;
    rebuilt.values = same_plan && from.values_hash != to.values_hash;
    return rebuilt;
}

}  // namespace

Result<FramePlan> StageMaker::make_plan(const ResolvedGraph& graph, const GraphRequest& request,
                                        const std::vector<ResourceDecl>& shared) const {
    CompileOptions options = compile_options(device_.profile(), settings_.queues);
    options.retained = find_retainable(graph, shared);
    FramePlan plan = compile(graph, vk::query_memory_needs(device_, graph), options);
    Diagnostics faults;
    if (settings_.check_plan) faults = check_plan(plan);
    if (faults.empty()) faults = find_excess(device_, plan, loader_.settings().limits.graph, request.path);
    if (faults.empty()) faults = find_missing_features(device_, plan);
    if (faults.empty()) faults = find_output_faults(plan, request.output, device_.profile());
    if (!faults.empty()) return faults;
    return plan;
}

Result<std::unique_ptr<SwapParts>> StageMaker::make(const Selection& selection, const ShaderCatalog& shaders,
                                                    const ResolvedGraph& graph,
                                                    const StageFingerprint& running) {
    Result<FramePlan> plan = make_plan(graph, selection.request, running.shared);
    if (!plan) return plan.take_errors();
    Result<FileUses> files = files_.acquire(plan->graph, loader_.settings());
    if (!files) return files.take_errors();
    auto next = std::make_unique<SwapParts>();
    next->selection = selection;
    next->follows = running.generation;
    next->fingerprint = take_fingerprint(*plan, shaders, selection.output);
    next->fingerprint.imports = selection.imports;
    for (const auto& [name, use] : *files) next->fingerprint.files.emplace(name, use.hash());
    next->rebuilt = compare(running, next->fingerprint);
    next->fingerprint.pipelines = running.pipelines;
    if (next->rebuilt.nothing()) return next;
    if (Status made = make_objects(*next, std::move(*plan), shaders, std::move(*files)); !made)
        return made.take_errors();
    const vk::PipelineCounts counts =
        next->stage ? next->stage->executor->pipelines() : next->amendment->pipelines();
    next->rebuilt.pipelines = next->fingerprint.pipelines = counts.all;
    next->rebuilt.made_pipelines = counts.made;
    if (running.generation > 0 && std::this_thread::get_id() == drawing_thread_)
        made_between_frames_ += counts.made;
    return next;
}

std::unique_ptr<SwapParts> StageMaker::make_values(const Selection& selection, ResolvedGraph graph,
                                                   StageFingerprint running) {
    auto next = std::make_unique<SwapParts>();
    next->selection = selection;
    next->follows = running.generation;
    next->fingerprint = std::move(running);
    const std::string hash = values_hash(graph);
    next->rebuilt.shaders = static_cast<uint32_t>(next->fingerprint.programs.size());
    next->rebuilt.pipelines = next->fingerprint.pipelines;
    next->rebuilt.values = hash != next->fingerprint.values_hash;
    next->fingerprint.values_hash = hash;
    if (next->rebuilt.values) next->amendment = vk::Executor::make_amendment(graph);
    next->resolved = std::move(graph);
    return next;
}

Status StageMaker::make_objects(SwapParts& next, FramePlan plan, const ShaderCatalog& shaders,
                                FileUses files) {
    const ImportCatalog imports = loader_.imports_at(next.selection.request);
    vk::ExecutorInput run;
    run.hooks.drop_barriers_of_position = position_of(plan, settings_.drop_barriers_before);
    run.plan = std::move(plan);
    run.shaders = &shaders;
    run.passes = &loader_.passes();
    run.draws = &scene_;
    run.pipelines = settings_.pipelines != nullptr ? settings_.pipelines : &pipelines_;
    run.shared = &shared_;
    run.timestamps = settings_.timestamps;
    run.imports = &imports;
    if (next.rebuilt.plan) {
        Result<RenderStage> stage = make_stage(std::move(run), next.selection, std::move(files));
        if (!stage) return stage.take_errors();
        next.stage = std::move(*stage);
        return Unit{};
    }
    Result<std::unique_ptr<vk::Amendment>> amendment = vk::Executor::make_amendment(device_, std::move(run));
    if (!amendment) return amendment.take_errors();
    next.amendment = std::move(*amendment);
    return Unit{};
}

Result<RenderStage> StageMaker::make_stage(vk::ExecutorInput run, const Selection& selection,
                                           FileUses files) const {
    RenderStage stage;
    const ResourceDecl& decl = run.imports->imports.at("backbuffer").resource;
    Result<vk::Image> output = selection.output != VK_NULL_HANDLE
                                   ? vk::Image::adopt(device_, selection.output, decl)
                                   : vk::Image::create(device_, decl);
    if (!output) return output.take_errors();
    stage.output = std::move(*output);
    scene_.bind(run.bindings);
    for (const auto& [name, views] : settings_.textures) run.bindings.textures.insert_or_assign(name, views);
    for (const auto& [name, unused] : run.bindings.textures) stage.tables.push_back(name);
    bind_files(run.plan.graph, files, run.bindings);
    stage.files = std::move(files);
    if (Status bound = bind_imports(run.plan, selection, stage, run.bindings); !bound)
        return bound.take_errors();
    // The bindings contain pointers to images of `stage`. These pointers need not stay valid, because the
    // executor uses the bindings only while it is created.
    run.bindings.images.emplace("backbuffer", &stage.output);
    Result<std::unique_ptr<vk::Executor>> executor = vk::Executor::create(device_, std::move(run));
    if (!executor) return executor.take_errors();
    stage.executor = std::move(*executor);
    if (Status viewed = view_kept_exports(device_, stage); !viewed) return viewed.take_errors();
    return stage;
}

// Binds the program's own imports, and creates the objects of the resources that the program uses.
Status StageMaker::bind_imports(const FramePlan& plan, const Selection& selection, RenderStage& stage,
                                vk::ImportBindings& bindings) const {
    for (ResourceId id(0); id < plan.graph.resources.size(); ++id) {
        const ResourceDecl& decl = plan.graph.resources[id];
        const auto own = selection.imports.find(decl.name);
        if (own != selection.imports.end() && decl.lifetime == ResourceLifetime::imported) {
            const ImportObject& object = own->second;
            if (object.buffer != VK_NULL_HANDLE) bindings.buffers.emplace(decl.name, object.buffer);
            if (object.slot_buffers.front() != VK_NULL_HANDLE)
                bindings.slot_buffers.emplace(decl.name, object.slot_buffers);
            if (object.image == VK_NULL_HANDLE) continue;
            Result<vk::Image> image = vk::Image::adopt(device_, object.image, decl);
            if (!image) return image.take_errors();
            const auto [kept, unused] = stage.own_images.emplace(decl.name, std::move(*image));
            bindings.images.emplace(decl.name, &kept->second);
        }
        const bool has_own_object =
            selection.request.exports.contains(decl.name) && decl.lifetime == ResourceLifetime::imported;
        if (!has_own_object || !plan.live.live_resources[id]) continue;
        const VkBufferUsageFlags usage =
            decl.kind == ResourceKind::buffer ? vk::buffer_create_info(decl).usage : 0;
        Result<DeviceObject> made = create_object(device_, decl, usage);
        if (!made) return made.take_errors();
        const DeviceObject& object = stage.exports.emplace(decl.name, std::move(*made)).first->second;
        if (decl.kind == ResourceKind::buffer)
            bindings.buffers.emplace(decl.name, object.buffer.handle());
        else
            bindings.images.emplace(decl.name, &object.image);
    }
    return Unit{};
}

}  // namespace weft::render
