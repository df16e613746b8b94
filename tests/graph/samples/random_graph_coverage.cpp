#include "tests/graph/samples/random_graph_coverage.h"

#include <algorithm>

namespace weft::test {
namespace {

template <class Items, class Predicate>
uint32_t any(const Items& items, Predicate predicate) {
    return std::any_of(items.begin(), items.end(), predicate) ? 1 : 0;
}

template <class Predicate>
uint32_t any_live_pass(const FramePlan& plan, Predicate predicate) {
    return any(plan.schedule.order, [&](PassId id) { return predicate(plan.graph.passes[id]); });
}

template <class Predicate>
uint32_t any_live_use(const FramePlan& plan, Predicate predicate) {
    return any_live_pass(plan, [&](const PassDecl& pass) {
        return any(pass.uses,
                   [&](const UseDecl& use) { return predicate(plan.graph.resources[use.resource]); }) != 0;
    });
}

template <class Predicate>
uint32_t any_use(const FramePlan& plan, Predicate predicate) {
    return any_live_pass(plan, [&](const PassDecl& pass) { return any(pass.uses, predicate) != 0; });
}

bool tests_against_its_input(const PassDecl& pass) {
    if (!pass.depth) return false;
    const ResourceId depth = pass.uses[pass.depth->use].resource;
    return any(pass.uses, [&](const UseDecl& use) {
               return use.resource == depth && use.access == Access::sampled_read;
           }) != 0;
}

}  // namespace

void GraphCoverage::add_views(const FramePlan& plan) {
    const auto draws = [&](ViewSource source) {
        return any(plan.graph.views, [&](const ViewListDecl& list) {
            return list.source == source && any_live_pass(plan, [&](const PassDecl& pass) {
                                                return pass.view.starts_with(list.name + "(");
                                            }) != 0;
        });
    };
    program_views += draws(ViewSource::program);
    mirrors += draws(ViewSource::mirror);
    cube_views += draws(ViewSource::cube);
    buffer_views += any_live_pass(plan, [](const PassDecl& pass) { return pass.view_use != kNoId; });
}

void GraphCoverage::add_indirect(const FramePlan& plan) {
    indirect_offsets += any_live_pass(plan, [](const PassDecl& pass) {
        return pass.indirect_use != kNoId && pass.uses[pass.indirect_use].bytes &&
               pass.uses[pass.indirect_use].bytes->offset_bytes > 0;
    });
    indirect_draws +=
        any_live_pass(plan, [](const PassDecl& pass) { return pass.draw_commands_use != kNoId; });
    draw_counts += any_live_pass(plan, [](const PassDecl& pass) { return pass.draw_count_use != kNoId; });
}

void GraphCoverage::add_samplers(const FramePlan& plan) {
    reductions +=
        any_use(plan, [](const UseDecl& use) { return use.sampler.reduction != SamplerReduction::average; });
    anisotropic += any_use(plan, [](const UseDecl& use) { return use.sampler.anisotropy > 1; });
    levels += any_use(
        plan, [](const UseDecl& use) { return use.sampler.lod_bias != 0 || use.sampler.min_lod > 0; });
}

void GraphCoverage::add(const FramePlan& plan, bool omitted) {
    ++graphs;
    alias_transitions +=
        any(plan.memory.alias_transitions, [](const AliasTransition& h) { return h.from != h.to; });
    several_queues += any(plan.schedule.queue, [](QueueIndex queue) { return queue != 0; });
    waits += any(plan.submissions.batches, [](const Batch& batch) {
        return any(batch.waits, [](const QueueWait& wait) { return !wait.previous_frame; }) != 0;
    });
    transfers += any(plan.barriers.steps, [](const PassStep& step) {
        return any(step.after, [](const BarrierDecl& b) { return b.src_family != b.dst_family; }) != 0;
    });
    history += any_live_use(plan, [](const ResourceDecl& r) { return r.age > 0; });
    kept += any_live_use(plan, [](const ResourceDecl& r) { return r.ring != kNoId && r.history == 0; });
    carried += any_live_pass(plan, [](const PassDecl& pass) { return pass.carries; });
    const auto has_barrier_on_part = [&](ResourceKind kind) {
        return any(plan.barriers.steps, [&](const PassStep& step) {
            return any(step.barriers, [&](const BarrierDecl& b) {
                       const ResourceDecl& resource = plan.graph.resources[b.resource];
                       return resource.kind == kind && b.range != resource.whole();
                   }) != 0;
        });
    };
    ranges += has_barrier_on_part(ResourceKind::image);
    buffer_ranges += has_barrier_on_part(ResourceKind::buffer);
    const auto is_round = [](const PassDecl& pass) { return pass.name.find('#') != std::string::npos; };
    repeats += any_live_pass(plan, is_round);
    chains += any_live_pass(plan, [&](const PassDecl& pass) {
        return !is_round(pass) && pass.name.find("_down_") != std::string::npos;
    });
    conditionals += omitted ? 1 : 0;
    after += any(plan.graph.edges, [](const EdgeDecl& edge) { return edge.kind == EdgeKind::after; });
    arrays += any_use(plan, [](const UseDecl& use) { return use.each == EachPart::mip; });
    layer_arrays += any_use(plan, [](const UseDecl& use) { return use.each == EachPart::layer; });
    add_views(plan);
    add_indirect(plan);
    add_samplers(plan);
    shared += any_live_use(plan, [](const ResourceDecl& r) { return r.shared; });
    files += any_live_use(plan, [](const ResourceDecl& r) { return !r.file.empty(); });
    scene_buffers += any_live_use(plan, [](const ResourceDecl& r) { return r.name == "instances"; });
    depth_inputs += any_live_pass(plan, tests_against_its_input);
    merged_scopes += any(plan.barriers.steps, [](const PassStep& step) { return step.merges_render_pass; });
    tables += any_live_use(plan, [](const ResourceDecl& r) { return r.textures > 0; });
    views += any_live_pass(plan, [](const PassDecl& pass) { return !pass.views.empty(); });
    culled += plan.schedule.order.size() < plan.graph.passes.size() ? 1 : 0;
}

std::string GraphCoverage::text() const {
    std::string all = std::to_string(graphs) + " graphs:";
    const auto share = [&](const char* what, uint32_t count) {
        all += std::string(all.back() == ':' ? " " : ", ") + what + " " +
               std::to_string(graphs == 0 ? 0 : (count * 100 + graphs / 2) / graphs) + " %";
    };
    share("alias transitions", alias_transitions);
    share("several queues", several_queues);
    share("cross-queue waits", waits);
    share("family transfers", transfers);
    share("history", history);
    share("kept", kept);
    share("carried", carried);
    share("subresource ranges", ranges);
    share("buffer ranges", buffer_ranges);
    share("repeats", repeats);
    share("mip chains made in memory", chains);
    share("conditionals", conditionals);
    share("after edges", after);
    share("arrays of mips", arrays);
    share("arrays of layers", layer_arrays);
    share("views of the program", program_views);
    share("mirrors", mirrors);
    share("views of a cube", cube_views);
    share("views in buffers", buffer_views);
    share("indirect dispatches with offsets", indirect_offsets);
    share("indirect draws", indirect_draws);
    share("draw counts", draw_counts);
    share("reductions", reductions);
    share("anisotropic filters", anisotropic);
    share("levels of samplers", levels);
    share("shared resources", shared);
    share("files", files);
    share("scene buffers", scene_buffers);
    share("depth as input", depth_inputs);
    share("tables of textures", tables);
    share("culled passes", culled);
    share("merged scopes", merged_scopes);
    share("several views at once", views);
    return all;
}

}  // namespace weft::test
