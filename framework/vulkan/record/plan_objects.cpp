#include "vulkan/record/plan_objects.h"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "vulkan/device/executor_errors.h"
#include "vulkan/pipelines/lowered_views.h"
#include "vulkan/pipelines/pass_shaders.h"
#include "vulkan/record/merged_scopes.h"
#include "vulkan/record/raw_pass.h"

namespace weft::vk {
namespace {

// Largest allowed period of a pass: the number of frames after which the pass uses the same copies of its
// resources with history again. Each of these frames needs descriptor sets of its own. 840 is the least
// common multiple of 1 to 8, so rings of up to 8 copies cannot exceed the limit.
constexpr uint64_t kMaxRingPhases = 840;

bool runs_shader(PassKind kind) {
    return kind == PassKind::compute || kind == PassKind::fullscreen || kind == PassKind::raster;
}

// True if the pass has exactly two uses, and both are images or both are buffers.
bool copies_like_to_like(const FramePlan& plan, const PassDecl& pass) {
    if (pass.uses.size() != 2) return false;
    return plan.graph.resources[pass.uses[0].resource].kind ==
           plan.graph.resources[pass.uses[1].resource].kind;
}

// True if llvmpipe would resolve this pass wrongly: llvmpipe (Mesa 22.3) always resolves from layer 0 to
// layer 0, whatever layers the views have.
bool is_resolved_elsewhere(const Device& device, const PassDecl& pass) {
    if (!device.info().driver.starts_with("llvmpipe")) return false;
    return std::any_of(pass.colors.begin(), pass.colors.end(), [&](const AttachmentDecl& color) {
        return color.resolve_use != kNoId &&
               (pass.uses[color.use].range.layer != 0 || pass.uses[color.resolve_use].range.layer != 0);
    });
}

// Checks that the device and the draw source can draw several views by one pass.
Diagnostics check_lowering(const Device& device, const FramePlan& plan, const ExecutorInput& input,
                           const PassDecl& pass, const ShaderProgram& program) {
    Diagnostics errors;
    // Each device with the feature multiview draws at least six views at once.
    constexpr uint32_t kLeastMultiviews = 6;
    const DeviceProfile& profile = device.profile();
    const bool multiview = pass.lowering == ViewLowering::multiview;
    uint32_t most = UINT32_MAX;
    if (multiview)
        most = device.optional().multiview ? std::max(kLeastMultiviews, profile.max_multiview_views) : 1;
    else if (pass.lowering == ViewLowering::layer_output)
        most = profile.max_output_layers;
    if (pass.views.size() > most)
        errors.push_back(pass_error(plan, pass, "V417",
                                    "the pass draws " + std::to_string(pass.views.size()) +
                                        " views at once, but the device draws at most " +
                                        std::to_string(most) + ": compile the graph with its profile"));
    const auto selects = [](const ShaderModule& module) { return can_select_view(module.spirv); };
    if (multiview && !std::ranges::all_of(program.modules, selects))
        errors.push_back(pass_error(plan, pass, "V417",
                                    "shader \"" + pass.shader +
                                        "\" copies the whole block of the view, so it cannot draw several "
                                        "views at once"));
    const bool uses_views = std::ranges::any_of(
        program.interface.bindings, [](const ShaderBinding& binding) { return binding.set == kFrameSet; });
    const bool lowered = pass.lowering != ViewLowering::none;
    if (lowered && uses_views && input.draws != nullptr && !input.draws->draws_several_views()) {
        errors.push_back(pass_error(plan, pass, "V415",
                                    "the pass draws several views at once, but the DrawSource of the program "
                                    "draws only one view at a time"));
        errors.back().help = {
            "set max_multiview_views and max_output_layers of the device profile to 1; or "
            "implement DrawSource::views_set() and draws_several_views()"};
    }
    return errors;
}

Diagnostics check_passes(const Device& device, const FramePlan& plan, const ExecutorInput& input) {
    Diagnostics errors;
    const Rings rings(plan);
    for (const PassId id : plan.schedule.order) {
        const PassDecl& pass = plan.graph.passes[id];
        const auto fault = [&](const std::string& what) {
            errors.push_back(pass_error(plan, pass, "V417", what));
        };
        if (rings.period(pass) > kMaxRingPhases)
            fault("the copies of its resources with history repeat together only after " +
                  std::to_string(rings.period(pass)) + " frames; the limit is " +
                  std::to_string(kMaxRingPhases));
        if ((pass.kind == PassKind::copy || pass.kind == PassKind::blit) && !copies_like_to_like(plan, pass))
            fault("a copy needs one input and one output, both images or both buffers");
        if (is_resolved_elsewhere(device, pass)) {
            fault(
                "the pass resolves into a layer after the first, but the driver llvmpipe resolves only into "
                "the first layer");
            errors.back().help = {"resolve into an image with one layer, and copy this image into the layer"};
        }
        if (pass.kind == PassKind::custom && (input.passes == nullptr || !input.passes->contains(pass.type)))
            fault("the program gave no pass type \"" + pass.type + "\"");
        for (const UseDecl& use : pass.uses)
            if (const std::string text = port_fault(plan, use);
                pass.kind == PassKind::custom && !text.empty()) {
                fault(text);
                errors.back().help = {"select one mip, for example \"" +
                                      plan.graph.resources[use.resource].name + ".mip(0)\""};
            }
        if (pass.kind == PassKind::raster && !pass.draw_lists.empty() && input.draws == nullptr)
            errors.push_back(
                pass_error(plan, pass, "V415",
                           "the pass draws the lists of a scene, but the program gave no DrawSource"));
        if (pass.draw_commands_use != kNoId && pass.draw_lists.size() > 1)
            fault("the pass draws " + std::to_string(pass.draw_lists.size()) +
                  " lists with one buffer of draw commands; wanted at most one list");
        if (!runs_shader(pass.kind)) continue;
        const ShaderProgram* program = program_of(input.shaders, pass);
        if (program == nullptr || program->modules.empty())
            fault("the program gave no shader \"" + pass.shader + "\"");
        else if (program->interface.has_params && program->interface.params.size_bytes != pass.params_bytes)
            fault("the plan has " + std::to_string(pass.params_bytes) +
                  " bytes of Params, but the shader declares " +
                  std::to_string(program->interface.params.size_bytes) + " bytes");
        if (program != nullptr) append(errors, check_lowering(device, plan, input, pass, *program));
    }
    return errors;
}

// Creates the objects of a plan that do not depend on shaders: heaps, the resource table, memory for host
// data, and timestamp queries.
Status make_memory(Device& device, const ExecutorInput& input, PlanObjects& objects) {
    Result<TransientHeap> heap = TransientHeap::create(device, objects.plan, *input.shared);
    if (!heap) return heap.take_errors();
    objects.heap = std::move(*heap);
    Result<ResourceTable> resources = bind_resources(objects.plan, objects.heap, input.bindings);
    if (!resources) return resources.take_errors();
    objects.resources = std::move(*resources);
    Result<ParamsMemory> params = ParamsMemory::create(device, objects.plan);
    if (!params) return params.take_errors();
    objects.params = std::move(*params);
    Result<UploadMemory> uploads = UploadMemory::create(device, objects.plan);
    if (!uploads) return uploads.take_errors();
    objects.uploads = std::move(*uploads);
    Result<ReadbackMemory> readbacks = ReadbackMemory::create(device, objects.plan);
    if (!readbacks) return readbacks.take_errors();
    objects.readbacks = std::move(*readbacks);
    Result<PassTimer> timer = PassTimer::create(device, objects.plan, input.timestamps);
    if (!timer) return timer.take_errors();
    objects.timer = std::move(*timer);
    return Unit{};
}

uint32_t variant_count(const PassDecl& pass) {
    return std::max(1u, static_cast<uint32_t>(pass.variants.size()));
}

// Makes the descriptor sets of a variant of the pass at index `position` of the execution order, for each
// frame of the period of the pass. After one period, the pass uses the same copies of its resources with
// history again.
Status prepare_port_sets(Device& device, PlanObjects& objects, Position position, const PassDecl& pass,
                         const ShaderInterface& interface) {
    PreparedPass& prepared = objects.passes[position];
    for (uint64_t frame = 0; frame < objects.resources.rings.period(pass); ++frame) {
        const DescriptorSources sources{objects.plan,  {objects.resources, frame}, objects.params,
                                        objects.views, objects.samplers,           objects.dummies};
        Result<SlotSets> sets =
            make_port_sets(device, objects.pool.get(), sources, position, pass, interface, prepared.layout);
        if (!sets) return sets.take_errors();
        prepared.port_sets.push_back(*sets);
    }
    return Unit{};
}

// Makes the rendering scope of a pass that draws, for frame `frame` of the period of the pass.
Status prepare_scope(PlanObjects& objects, Position position, uint64_t frame) {
    PreparedPass& prepared = objects.passes[position];
    const PassStep& step = objects.plan.barriers.steps[position];
    if (objects.plan.graph.passes[step.pass].kind == PassKind::compute) return Unit{};
    Result<RenderingScope> scope =
        make_rendering_scope(objects.plan, step_of_scope(objects.plan, position), objects.views, frame);
    if (!scope) return scope.take_errors();
    scope->begins = !step.merges_render_pass;
    scope->ends = !scope_continues(objects.plan, position);
    prepared.scopes.push_back(std::move(*scope));
    return Unit{};
}

Status prepare_shader_pass(Device& device, const ExecutorInput& input, PlanObjects& objects,
                           Position position) {
    const PassDecl& pass = objects.plan.graph.passes[objects.plan.schedule.order[position]];
    const ShaderProgram& program = *program_of(input.shaders, pass);
    PreparedPass& prepared = objects.passes[position];
    Result<PassLayout> layout = make_pass_layout(device, objects.plan, pass, program.interface, input.draws);
    if (!layout) return layout.take_errors();
    prepared.layout = std::move(*layout);
    prepared.frame_ranges = program.interface.frame_ranges;
    for (uint64_t frame = 0; frame < objects.resources.rings.period(pass); ++frame) {
        Status scope = prepare_scope(objects, position, frame);
        if (!scope) return scope;
    }
    prepared.variants = variant_count(pass);
    for (uint32_t variant = 0; variant < prepared.variants; ++variant) {
        const PassDecl decl = pass_of_variant(pass, variant);
        Status sets = prepare_port_sets(device, objects, position, decl, program.interface);
        if (!sets) return sets;
        Result<std::vector<DrawPipeline>> pipelines =
            make_pipelines(device, {objects.plan, decl, program, prepared.layout, input.imports, input.draws,
                                    objects.cache.get(), *input.pipelines, objects.pipeline_counts});
        if (!pipelines) return pipelines.take_errors();
        std::ranges::move(*pipelines, std::back_inserter(prepared.pipelines));
    }
    return Unit{};
}

Status prepare_custom_pass(const ExecutorInput& input, PlanObjects& objects, Position position) {
    const PassDecl& pass = objects.plan.graph.passes[objects.plan.schedule.order[position]];
    PreparedPass& prepared = objects.passes[position];
    prepared.type = input.passes->find(pass.type)->second;
    for (uint64_t frame = 0; frame < objects.resources.rings.period(pass); ++frame) {
        Result<std::vector<VkImageView>> views = make_port_views(pass, objects.views, frame);
        if (!views) return views.take_errors();
        prepared.port_views.push_back(std::move(*views));
    }
    return Unit{};
}

Status make_pool(Device& device, const ExecutorInput& input, PlanObjects& objects) {
    std::vector<SetDemand> demands;
    for (const PassId id : objects.plan.schedule.order) {
        const PassDecl& pass = objects.plan.graph.passes[id];
        if (!runs_shader(pass.kind)) continue;
        demands.push_back({&program_of(input.shaders, pass)->interface, &pass,
                           static_cast<uint32_t>(objects.resources.rings.period(pass)), variant_count(pass)});
    }
    Result<DescriptorPoolHandle> pool = make_descriptor_pool(device, objects.plan.graph, demands);
    if (!pool) return pool.take_errors();
    objects.pool = std::move(*pool);
    Result<PipelineCacheHandle> cache = make_pipeline_cache(device);
    if (!cache) return cache.take_errors();
    objects.cache = std::move(*cache);
    return Unit{};
}

Result<std::vector<DrawPipeline>> make_new_pipelines(Device& device, const ExecutorInput& input,
                                                     VkPipelineCache cache, PlanAmendment& amendment,
                                                     const PassDecl& pass) {
    const ShaderProgram& program = *program_of(input.shaders, pass);
    // A pipeline works with every compatible pipeline layout. This layout is only needed to create the
    // pipeline.
    Result<PassLayout> layout = make_pass_layout(device, input.plan, pass, program.interface, input.draws);
    if (!layout) return layout.take_errors();
    std::vector<DrawPipeline> all;
    for (uint32_t variant = 0; variant < variant_count(pass); ++variant) {
        const PassDecl decl = pass_of_variant(pass, variant);
        Result<std::vector<DrawPipeline>> pipelines =
            make_pipelines(device, {input.plan, decl, program, *layout, input.imports, input.draws, cache,
                                    *input.pipelines, amendment.counts});
        if (!pipelines) return pipelines.take_errors();
        std::ranges::move(*pipelines, std::back_inserter(all));
    }
    return all;
}

}  // namespace

Result<std::unique_ptr<PlanObjects>> make_plan_objects(Device& device, ExecutorInput input) {
    ShaderCatalog changed;
    input.shaders = shaders_for(device, input, changed);
    Diagnostics errors = check_passes(device, input.plan, input);
    if (!errors.empty()) return errors;
    auto objects = std::make_unique<PlanObjects>(device, std::move(input.plan));
    objects->draws = input.draws;
    if (input.pipelines == nullptr) {
        objects->own_pipelines = std::make_unique<PipelineStore>();
        input.pipelines = objects->own_pipelines.get();
    }
    if (input.shared == nullptr) {
        objects->own_shared = std::make_unique<SharedStore>();
        input.shared = objects->own_shared.get();
    }
    if (Status made = make_memory(device, input, *objects); !made) return made.take_errors();
    if (Status made = make_pool(device, input, *objects); !made) return made.take_errors();
    const std::vector<PassId>& order = objects->plan.schedule.order;
    objects->passes.resize(order.size());
    for (Position position(0); position < order.size(); ++position) {
        const PassDecl& pass = objects->plan.graph.passes[order[position]];
        const bool custom = pass.kind == PassKind::custom;
        if (!custom && !runs_shader(pass.kind)) continue;
        device.messages().set_current_pass(pass.name);
        const Status prepared = custom ? prepare_custom_pass(input, *objects, position)
                                       : prepare_shader_pass(device, input, *objects, position);
        if (!prepared) append(errors, prepared.errors());
    }
    device.messages().set_current_pass("");
    if (!errors.empty()) return errors;
    Result<PassViewSets> views = PassViewSets::create(objects->plan, objects->resources, input.draws);
    if (!views) return views.take_errors();
    objects->view_sets = std::move(*views);
    return objects;
}

Result<std::unique_ptr<PlanAmendment>> make_plan_amendment(Device& device, ExecutorInput input) {
    assert(input.pipelines != nullptr && "without a store nothing would be left as it is");
    ShaderCatalog changed;
    input.shaders = shaders_for(device, input, changed);
    Diagnostics errors = check_passes(device, input.plan, input);
    if (!errors.empty()) return errors;
    Result<PipelineCacheHandle> cache = make_pipeline_cache(device);
    if (!cache) return cache.take_errors();
    auto amendment = std::make_unique<PlanAmendment>();
    for (const PassId id : input.plan.schedule.order) {
        std::vector<DrawPipeline>& place = amendment->passes.emplace_back();
        std::vector<FrameRange>& ranges = amendment->frame_ranges.emplace_back();
        const PassDecl& pass = input.plan.graph.passes[id];
        if (!runs_shader(pass.kind)) continue;
        ranges = program_of(input.shaders, pass)->interface.frame_ranges;
        device.messages().set_current_pass(pass.name);
        Result<std::vector<DrawPipeline>> pipelines =
            make_new_pipelines(device, input, cache->get(), *amendment, pass);
        if (pipelines)
            place = std::move(*pipelines);
        else
            append(errors, pipelines.errors());
    }
    device.messages().set_current_pass("");
    if (!errors.empty()) return errors;
    amendment->graph = std::move(input.plan.graph);
    return amendment;
}

}  // namespace weft::vk
