#include "weft/render/session.h"
#include "graph/diagnostics/make_error.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "render/imports/output_import.h"
#include "render/imports/program_imports.h"
#include "render/parts/pending_part.h"
#include "render/session_parts.h"
#include "render/unsupported_report.h"
#include "scene/model/light_check.h"
#include "weft/render/import_catalog.h"

namespace weft::render {
namespace {

// Returns the imports of the scene and of the program, and sets which queue family owns the Vulkan objects of
// the scene. If the device has queues of several families, the objects are shared by all these families;
// otherwise the main queue's family owns them.
ImportCatalog owned_imports(const vk::Device& device, const scene::Scene& scene, const SessionInput& input) {
    ImportCatalog catalog = scene_imports(input.request.size, &scene, &input.probes);
    for (const auto& [name, count] : input.views)
        catalog.imports.insert_or_assign(name, view_list(name, count));
    for (const auto& [name, views] : input.textures)
        catalog.imports.insert_or_assign(name, texture_table(name, static_cast<uint32_t>(views.size())));
    for (auto& [name, import] : catalog.imports) {
        if (!import.resource.import) continue;
        import.resource.import->concurrent = !device.sharing_families().empty();
        import.resource.import->family = device.queue().family;
    }
    // In a session without a scene, the lights come from FrameInput::lights. Their number is not known yet,
    // so 1 directional light is assumed.
    if (scene.instances.empty() && scene.lights.empty()) catalog.numbers["directionalLights"] = 1;
    add_program_imports(input, catalog);
    return catalog;
}

Diagnostic no_passes() {
    return make_error("W254", "SessionInput::passes is null, so the session knows no pass types in C++",
                      {"let it point to the result of weft::registered_passes() (weft/registry.h)"});
}

void append(Diagnostics& to, Diagnostics from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

}  // namespace

VkImageCreateInfo output_create_info(const vk::Device& device, Extent3D size, const OutputFormat& output) {
    GraphRequest request;
    request.size = size;
    request.output = output;
    ImportCatalog imports = scene_imports(size);
    set_output(imports, request, device.profile());
    VkImageCreateInfo info = vk::image_create_info(imports.imports.at("backbuffer").resource);
    vk::share(info, vk::concurrent_sharing(device));
    return info;
}

Session::Session(std::unique_ptr<SessionParts> parts) : parts_(std::move(parts)) {}
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

Result<std::unique_ptr<Session>> Session::create(vk::Device& device, const SessionInput& input,
                                                 Diagnostics& warnings,
                                                 std::set<std::filesystem::path>* files) {
    return create(device, scene::Scene{}, nullptr, input, warnings, files);
}

Result<std::unique_ptr<Session>> Session::create(vk::Device& device, const scene::Scene& scene,
                                                 scene::Scene* owned, const SessionInput& input,
                                                 Diagnostics& warnings,
                                                 std::set<std::filesystem::path>* files) {
    const size_t known_warnings = warnings.size();
    if (input.passes == nullptr) return no_passes();
    if (Diagnostics faults = program_import_faults(device, input, scene); !faults.empty()) return faults;
    auto graph = std::make_unique<RunningGraph>(device, input, owned_imports(device, scene, input));
    const Status loaded = graph->load_first(input.parsed, warnings);
    if (files != nullptr) files->insert(graph->first_files().begin(), graph->first_files().end());
    if (!loaded) return loaded.errors();
    Result<DrawnScene> drawn = DrawnScene::create(
        device, scene,
        {input.draw_lists, input.draw_sets, input.moves_instances, input.adds_parts, input.probes}, owned);
    if (!drawn) return drawn.take_errors();
    Result<PendingSwap> first = graph->start(device, drawn->gpu(), StageSettings(input));
    if (!first) return first.take_errors();
    if (Status uploaded = upload_files(first->parts().stage->files); !uploaded) return uploaded.take_errors();
    FrameLoop frames(std::move(*first->parts().stage), input.request.size, graph->loaded().desc.jitter);
    graph->adopt(first->parts());
    std::unique_ptr<Session> session(new Session(std::make_unique<SessionParts>(
        SessionParts{device, std::move(*drawn), std::move(graph), std::move(frames)})));
    append(warnings, scene::light_warnings(scene));
    append(warnings, report_unsupported(session->plan(), scene));
    device.log(warnings, known_warnings);
    return session;
}

const Selection& Session::selection() const {
    return parts_->graph->selection();
}

const std::set<std::filesystem::path>& Session::first_files() const {
    return parts_->graph->first_files();
}

PrepareResult Session::prepare(const Selection& selection) {
    PrepareResult prepared = parts_->graph->prepare(selection);
    parts_->device.log(prepared.warnings);
    return prepared;
}

Result<bool> Session::swap_in(PendingSwap next) {
    RunningGraph& graph = *parts_->graph;
    FrameLoop& frames = parts_->frames;
    SwapParts& swap = next.parts();
    if (!graph.is_next(swap)) return false;
    if (swap.amendment) frames.amend(std::move(swap.amendment));
    if (swap.stage) {
        Status taken = frames.take_over(std::move(*swap.stage), graph.checks_plans());
        if (!taken) return taken.take_errors();
    }
    graph.adopt(swap);
    frames.set_graph(graph.selection().request.size, graph.loaded().desc.jitter);
    return true;
}

Status Session::resize(Extent3D size, Diagnostics& warnings, VkImage output) {
    if (size == selection().request.size && output == selection().output) return Unit{};
    Selection next = selection();
    next.request.size = size;
    next.output = output;
    return change_selection(next, warnings);
}

Status Session::rebind(const std::string& import, const ImportObject& object, const ImportSize& size,
                       Diagnostics& warnings) {
    Selection next = selection();
    const auto found = next.imports.find(import);
    if (found == next.imports.end()) {
        return make_error("W245",
                          "Session::rebind() names \"" + import + "\", which is no import of the program",
                          {"use a name in SessionInput::imports"});
    }
    found->second = object;
    next.request.import_sizes[import] = size;
    return change_selection(next, warnings);
}

Status Session::change_selection(const Selection& selection, Diagnostics& warnings) {
    const size_t known_warnings = warnings.size();
    Result<PendingSwap> next = parts_->graph->prepare_loaded(selection, warnings);
    parts_->device.log(warnings, known_warnings);
    if (!next) return next.take_errors();
    // The value of `swapped` is never false: only this thread swaps graphs, so no other swap can have
    // happened since prepare_loaded().
    Result<bool> swapped = swap_in(std::move(*next));
    return swapped ? Status(Unit{}) : Status(swapped.take_errors());
}

uint64_t Session::pipelines_made_between_frames() const {
    return parts_->graph->pipelines_made_between_frames();
}

std::optional<ExportedResource> Session::exported(std::string_view name) const {
    return parts_->frames.exported(name);
}

Result<ScenePart> Session::prepare_part(const scene::Scene& scene, bool moves_instances) const {
    return make_part(parts_->device, scene, moves_instances);
}

Result<PartId> Session::add_part(ScenePart part) {
    if (!parts_->scene.gpu().takes_parts()) {
        return make_error("W246", "the session was created for a scene to which no parts are added",
                          {"set SessionInput::adds_parts to true"});
    }
    if (parts_->scene.gpu().replaces_sets()) {
        return make_error(
            "W246", "SessionInput::draw_sets replaces descriptor sets that the draws of the added part need",
            {"draw the meshes in a draw list of the program, or create the session without draw_sets"});
    }
    const std::unique_ptr<PendingPart> pending = part.take();
    return parts_->scene.gpu().parts().add(std::move(pending->part), std::move(pending->uploads));
}

Status Session::remove_part(PartId part) {
    if (parts_->scene.gpu().parts().remove(part, parts_->frames.next_free_frame())) return Unit{};
    return make_error("W247", "the session has no added part with the number " + std::to_string(part),
                      {"use a number that Session::add_part() has returned, and remove each part only once"});
}

uint32_t Session::probe_count() const {
    return static_cast<uint32_t>(parts_->scene.gpu().probes().points().size());
}

uint32_t Session::reflection_probe_count() const {
    return static_cast<uint32_t>(parts_->scene.gpu().probes().reflection_points().size());
}

Result<std::vector<vk::FrameTiming>> Session::warm_up_probes(const FrameInput& first,
                                                             const ProbeWarmUp& settings) {
    const uint32_t probes = parts_->frames.takes_turns(kProbeTurns) ? probe_count() : 0;
    const uint32_t reflections = parts_->frames.takes_turns(kReflectionTurns) ? reflection_probe_count() : 0;
    const uint32_t all = settings.rounds * probes + (settings.rounds > 0 ? reflections : 0);
    const uint32_t step = std::max(1u, settings.most_per_frame);
    std::vector<vk::FrameTiming> timings;
    const auto collect = [&] {
        static_cast<void>(take_readbacks());
        std::ranges::move(take_timings(), std::back_inserter(timings));
    };
    FrameInput frame = first;
    frame.submit = {};
    uint32_t done = 0;
    // Renders frames until each probe of one kind has had a turn: at most `step` probes per frame. The probes
    // of the other kind have no turns in these frames.
    const auto run = [&](const char* import, uint32_t count) -> Status {
        for (uint32_t begin = 0; begin < count; begin += step) {
            std::vector<uint32_t> turns(std::min(step, count - begin));
            std::iota(turns.begin(), turns.end(), begin);
            frame.turns[kProbeTurns].clear();
            frame.turns[kReflectionTurns].clear();
            frame.turns[import] = turns;
            if (Status rendered = render_frame(frame, true); !rendered) return rendered;
            collect();
            done += static_cast<uint32_t>(turns.size());
            if (settings.progress) settings.progress(done, all);
        }
        return Unit{};
    };
    for (uint32_t round = 0; round < settings.rounds; ++round)
        if (Status ran = run(kProbeTurns, probes); !ran) return ran.take_errors();
    // Reflection probes show the light of the irradiance probes, so they come last.
    if (all > 0)
        if (Status ran = run(kReflectionTurns, reflections); !ran) return ran.take_errors();
    if (all == 0) return timings;
    if (Status finished = finish(); !finished) return finished.take_errors();
    collect();
    return timings;
}

Status Session::render_frame(const FrameInput& input) {
    return render_frame(input, false);
}

Status Session::render_frame(const FrameInput& input, bool warms_up) {
    Result<std::unique_ptr<vk::Amendment>> values = parts_->graph->set_parameters(input.parameters);
    if (!values) return values.take_errors();
    if (*values) parts_->frames.amend(std::move(*values));
    return parts_->frames.render(input, parts_->graph->live_inputs(), parts_->scene,
                                 warms_up ? FrameLoop::Kind::warm_up : FrameLoop::Kind::normal);
}

Status Session::finish() {
    return parts_->frames.finish();
}

bool Session::has_output() const {
    return parts_->frames.has_output();
}

Result<vk::ReadbackData> Session::read_output() {
    return parts_->frames.read_output();
}

std::vector<vk::ReadbackData> Session::take_readbacks() {
    return parts_->frames.executor().take_readbacks();
}

std::vector<vk::FrameTiming> Session::take_timings() {
    return parts_->frames.executor().take_timings();
}

const FramePlan& Session::plan() const {
    return parts_->frames.plan();
}

uint32_t Session::frames() const {
    return parts_->graph->loaded().graph.frames;
}

float Session::pre_exposure() const {
    return parts_->frames.pre_exposure();
}

}  // namespace weft::render
