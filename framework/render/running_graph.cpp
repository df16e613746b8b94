#include "render/running_graph.h"

#include <algorithm>
#include <utility>

#include "render/imports/output_import.h"
#include "weft/compile.h"

namespace weft::render {
namespace {

// Returns SwapParts that replace nothing, because the selected graph runs already.
std::unique_ptr<SwapParts> keep_running(const Selection& selection, StageFingerprint running) {
    auto next = std::make_unique<SwapParts>();
    next->selection = selection;
    next->follows = running.generation;
    next->rebuilt.shaders = static_cast<uint32_t>(running.programs.size());
    next->fingerprint = std::move(running);
    return next;
}

bool is_switch(const ResolvedGraph& graph, const std::string& name) {
    return std::ranges::find(graph.switches, name, &SwitchDecl::param) != graph.switches.end();
}

// Returns true if the parameter scales a live size, a size of an image that can change while the plan runs.
bool is_scale(const ResolvedGraph& graph, const std::string& name) {
    return std::ranges::any_of(graph.live_values, [&](const LiveValue& value) {
        return value.param != kNoId && value.most > 0 && graph.params[value.param].name == name;
    });
}

Diagnostic cannot_set(const ResolvedGraph& graph, const std::string& name) {
    const auto param = std::ranges::find(graph.params, name, &GraphParam::name);
    Diagnostic d;
    d.code = "W242";
    if (param == graph.params.end()) {
        d.message = "FrameInput::parameters sets \"" + name + "\", which is no parameter of the graph";
        std::vector<std::string> names;
        for (const GraphParam& known : graph.params) names.push_back(known.name);
        if (const std::string near = did_you_mean_text(name, names); !near.empty()) d.help = {near};
    } else {
        d.message = "FrameInput::parameters sets \"" + name +
                    "\", but a change of this parameter needs new " +
                    (param->cost == ParamCost::pipeline ? "pipelines" : "objects: it changes the plan");
        d.help = {
            "give the value in Selection::request.params to Session::prepare(), and swap the result in"};
    }
    return d;
}

Diagnostic cannot_have(const ResolvedGraph& graph, const ParameterValues& values) {
    Diagnostic d;
    d.code = "W242";
    d.message = "FrameInput::parameters has a value that the graph does not allow:";
    for (const auto& [name, value] : values) d.message += " " + name + " = " + std::to_string(value);
    d.help = {"choose values in the ranges that \"params\" of graph \"" + graph.name + "\" gives"};
    return d;
}

}  // namespace

RunningGraph::RunningGraph(const vk::Device& device, const SessionInput& input, ImportCatalog imports)
    : loader_(device.profile(), input.load, *input.passes, std::move(imports)),
      selection_{input.request, input.output, {}} {
    for (const auto& [name, own] : input.imports) selection_.imports.emplace(name, own.object);
}

Status RunningGraph::load_first(const ParsedGraph* parsed, Diagnostics& warnings) {
    if (Status possible = check_output(selection_.request.output, loader_.profile()); !possible)
        return possible;
    Result<LoadedVersion> loaded = loader_.load(selection_.request, parsed, 0, warnings, first_files_);
    if (!loaded) return loaded.take_errors();
    loaded_ = std::move(*loaded->graph);
    fingerprint_.load = loaded->number;
    return Unit{};
}

Result<PendingSwap> RunningGraph::start(vk::Device& device, const GpuScene& scene,
                                        const StageSettings& settings) {
    maker_ = std::make_unique<StageMaker>(device, scene, loader_, settings);
    Result<std::unique_ptr<SwapParts>> first =
        maker_->make(selection_, loaded_.shaders, loaded_.graph, StageFingerprint{});
    if (!first) return first.take_errors();
    (*first)->fingerprint.load = fingerprint_.load;
    return PendingSwap(std::move(*first));
}

StageFingerprint RunningGraph::running() const {
    const std::lock_guard lock(fingerprint_mutex_);
    return fingerprint_;
}

PrepareResult RunningGraph::prepare(const Selection& selection) {
    const std::lock_guard one_at_a_time(preparing_);
    Diagnostics warnings;
    std::set<std::filesystem::path> files;
    if (Status possible = check_output(selection.request.output, loader_.profile()); !possible)
        return {possible.take_errors(), std::move(warnings), std::move(files)};
    StageFingerprint now = running();
    // If the output image or an import is another one, the stage must be made again, and this needs the
    // graph. Then `known` is 0, so that load() returns the graph even if no file has changed.
    const bool same_objects = now.output == selection.output && now.imports == selection.imports;
    const uint64_t known = same_objects ? now.load : 0;
    Result<LoadedVersion> loaded = loader_.load(selection.request, nullptr, known, warnings, files);
    if (!loaded) return {loaded.take_errors(), std::move(warnings), std::move(files)};
    if (!loaded->graph) {
        std::unique_ptr<SwapParts> same;
        if (loaded->values) {
            now.load = loaded->number;
            same = StageMaker::make_values(selection, std::move(*loaded->values), std::move(now));
            if (same->rebuilt.nothing()) note_same(*same);
        } else {
            same = keep_running(selection, std::move(now));
        }
        return {PendingSwap(std::move(same)), std::move(warnings), std::move(files)};
    }
    LoadedGraph& graph = *loaded->graph;
    Result<std::unique_ptr<SwapParts>> next = maker_->make(selection, graph.shaders, graph.graph, now);
    if (!next) return {next.take_errors(), std::move(warnings), std::move(files)};
    (*next)->fingerprint.load = loaded->number;
    (*next)->loaded = std::move(graph);
    if ((*next)->rebuilt.nothing()) note_same(**next);
    return {PendingSwap(std::move(*next)), std::move(warnings), std::move(files)};
}

Result<PendingSwap> RunningGraph::prepare_loaded(const Selection& selection, Diagnostics& warnings) {
    Result<ResolvedGraph> graph = loader_.resolve_again(loaded_, selection.request, warnings);
    if (!graph) return graph.take_errors();
    Result<std::unique_ptr<SwapParts>> next = maker_->make(selection, loaded_.shaders, *graph, running());
    if (!next) return next.take_errors();
    (*next)->resolved = std::move(*graph);
    return PendingSwap(std::move(*next));
}

Result<std::unique_ptr<vk::Amendment>> RunningGraph::set_parameters(const ParameterValues& values) {
    const ResolvedGraph& graph = loaded_.graph;
    bool changed = false;
    for (const auto& [name, value] : values) {
        if (is_switch(graph, name) || is_scale(graph, name)) continue;
        const auto param = std::ranges::find(graph.params, name, &GraphParam::name);
        if (param == graph.params.end() || param->cost > ParamCost::live) return cannot_set(graph, name);
        changed |= param->value != value;
    }
    std::unique_ptr<vk::Amendment> amendment;
    if (changed) {
        Result<std::unique_ptr<vk::Amendment>> made = change_values(values);
        if (!made) return made;
        amendment = std::move(*made);
    }
    for (const auto& [name, value] : values) {
        if (is_switch(graph, name)) live_inputs_.switches.insert_or_assign(name, value != 0);
        if (is_scale(graph, name)) live_inputs_.scales.insert_or_assign(name, value);
    }
    return amendment;
}

// Evaluates the expressions of the running graph with other values of parameters. Switches and scales keep
// the values that the plan has.
Result<std::unique_ptr<vk::Amendment>> RunningGraph::change_values(const ParameterValues& values) {
    // The values of the running graph may differ from those of the selection.
    GraphRequest from = selection_.request;
    for (const GraphParam& param : loaded_.graph.params) from.params[param.name] = param.value;
    GraphRequest to = from;
    for (const auto& [name, value] : values)
        if (!is_switch(loaded_.graph, name) && !is_scale(loaded_.graph, name)) to.params[name] = value;
    std::optional<ResolvedGraph> graph = loader_.with_values(loaded_, from, to);
    if (!graph) return cannot_have(loaded_.graph, find_wrong(from, values));
    loaded_.graph = *graph;
    const std::lock_guard lock(fingerprint_mutex_);
    fingerprint_.values_hash = values_hash(*graph);
    return vk::Executor::make_amendment(std::move(*graph));
}

// Tests each value alone, and returns the values that the graph does not allow. If the graph allows each
// value alone, only several values together are wrong. Then the function returns all values.
ParameterValues RunningGraph::find_wrong(const GraphRequest& from, const ParameterValues& values) const {
    ParameterValues wrong;
    for (const auto& [name, value] : values) {
        if (is_switch(loaded_.graph, name) || is_scale(loaded_.graph, name)) continue;
        GraphRequest alone = from;
        alone.params[name] = value;
        if (!loader_.with_values(loaded_, from, alone)) wrong.emplace(name, value);
    }
    return wrong.empty() ? values : wrong;
}

void RunningGraph::note_same(const SwapParts& next) {
    const std::lock_guard lock(fingerprint_mutex_);
    if (fingerprint_.generation == next.follows) fingerprint_.load = next.fingerprint.load;
}

bool RunningGraph::is_next(const SwapParts& next) const {
    return next.follows == running().generation;
}

void RunningGraph::adopt(SwapParts& next) {
    selection_ = std::move(next.selection);
    live_inputs_ = {};
    if (next.loaded) loaded_ = std::move(*next.loaded);
    if (next.resolved) loaded_.graph = std::move(*next.resolved);
    const std::lock_guard lock(fingerprint_mutex_);
    const uint64_t generation = fingerprint_.generation + 1;
    fingerprint_ = std::move(next.fingerprint);
    fingerprint_.generation = generation;
}

}  // namespace weft::render
