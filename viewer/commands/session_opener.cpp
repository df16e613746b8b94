#include "viewer/commands/session_opener.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "graph/diagnostics/quoted_list.h"
#include "graph/parse/debug_view.h"
#include "viewer/commands/load_settings.h"
#include "viewer/commands/probe_source.h"
#include "viewer/commands/scene_source.h"
#include "viewer/files/files.h"
#include "viewer/output/report.h"
#include "weft/load/load_graph.h"
#include "weft/registry.h"
#include "weft/render/import_catalog.h"

namespace weft::viewer {
namespace {

// The name of the parameter of modules/exposure.json that turns the automatic exposure on and off.
constexpr std::string_view kAutoExposure = "autoExposure";

// Returns the names of the parameters `autoExposure` of the graph and of its modules.
std::vector<std::string> auto_exposure_params(const GraphDesc& graph) {
    std::vector<std::string> names;
    for (const auto& [name, param] : graph.params)
        if (name == kAutoExposure || name.ends_with("::" + std::string(kAutoExposure))) names.push_back(name);
    return names;
}

// Warns if the environment picture is so dark or so bright that the rendered picture is black or white. With
// automatic exposure, this happens only if the values exceed what an image with half floats can store. Texels
// of the environment picture are luminances in cd/m².
void warn_of_exposure(const scene::Scene& scene, float exposure_ev, bool automatic) {
    constexpr float kMiddleGrey = 0.18f;
    const float most_stops = automatic ? 10 : 6;
    const float mean = mean_luminance(scene.environment);
    if (mean <= 0) return;
    const float stops = std::log2(mean / kMiddleGrey) + exposure_ev;
    if (std::abs(stops) <= most_stops) return;
    Diagnostic d;
    d.code = "S182";
    d.severity = Severity::warning;
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(), "%.0f stops too %s for the exposure of %g EV", std::abs(stops),
                  stops < 0 ? "dark" : "bright", exposure_ev);
    d.message = "the environment \"" + scene.environment.name + "\" is " + text.data();
    std::snprintf(text.data(), text.size(), "use --exposure %.1f, or a picture with values in cd/m²",
                  exposure_ev - stops);
    d.help = {text.data()};
    report({d});
}

}  // namespace

render::SessionInput session_input(const RenderOptions& options, const PassCatalog& passes) {
    render::SessionInput input;
    input.adds_parts = false;
    input.request = options.request;
    if (input.request.path.empty()) input.request.path = (shipped_root() / "graphs" / "weft.json").string();
    if (!options.resource.empty()) input.request.observed.push_back(options.resource);
    if (!input.request.debug.empty()) input.request.observed.emplace_back(kDebugView);
    input.load = load_settings(options.limits, options.graph_path);
    input.passes = &passes;
    input.queues = options.queues;
    input.check_plan = options.validate;
    input.timestamps = !options.stats.empty() && !options.validate;
    input.drop_barriers_before = options.drop_barriers_before;
    return input;
}

render::FrameInput frame_input(const RenderOptions& options, const scene::Scene& scene,
                               const scene::Camera& camera) {
    return {.camera = camera,
            .exposure_ev = options.exposure_ev.value_or(scene.exposure_ev),
            .turns = options.turns};
}

Result<std::unique_ptr<vk::Device>> open_device(const RenderOptions& options) {
    vk::DeviceOptions device_options;
    device_options.validate = options.validate;
    device_options.device = options.device;
    device_options.queues = options.queues;
    device_options.timeout_ns = static_cast<uint64_t>(options.timeout_s * 1e9);
    return vk::Device::create(device_options);
}

SessionOpener::SessionOpener(const RenderOptions& options, Attempts attempts)
    : options_(options),
      attempts_(attempts),
      passes_(registered_passes()),
      input_(session_input(options, passes_)) {}

// Checks that the graph has an import of kind "turns" for each list that --turns gives on the command line.
Status check_turns(const RenderOptions& options, const GraphDesc& graph) {
    std::vector<std::string> known;
    for (const auto& [name, import] : graph.imports)
        if (import.kind == "turns") known.push_back(name);
    for (const auto& [name, rounds] : options.turns) {
        if (std::ranges::find(known, name) != known.end()) continue;
        Diagnostic d;
        d.code = "X523";
        d.message = "the graph has no import \"" + name + "\" of kind \"turns\"";
        const std::string near = did_you_mean_text(name, known);
        if (!near.empty()) d.help.push_back(near);
        d.help.push_back(known.empty() ? "remove --turns: no group of this graph takes a list of turns"
                                       : "the lists of turns of this graph are " + quoted_list(known));
        return Diagnostics{d};
    }
    return Unit{};
}

// Parses and checks the graph file. open() calls this function before the slow work of loading a scene and
// creating a device, so that the user soon sees an error in the file.
Result<ParsedGraph> SessionOpener::parse_checked() {
    Result<ParsedGraph> parsed = parse_graph(input_.request, input_.load, &files_);
    if (!parsed) return parsed;
    if (Status turns = check_turns(options_, parsed->desc); !turns) return turns.take_errors();
    Status good = check_request(*parsed, input_.request, render::scene_imports(input_.request.size));
    return good ? std::move(parsed) : good.take_errors();
}

Status SessionOpener::load_scene(bool automatic_exposure) {
    if (!options_.camera_path.empty()) {
        Result<scene::CameraPath> path =
            scene::read_camera_path(options_.camera_path, reader_up_to(options_.limits.graph.json_bytes));
        if (!path) return path.take_errors();
        camera_path_ = std::move(*path);
    }
    Diagnostics warnings;
    Result<scene::Scene> scene = open_scene(
        {options_.scene, options_.env, options_.hour, options_.lights, options_.seed, options_.env_gain},
        options_.limits.scene, warnings);
    if (!options_.quiet) report(warnings);
    if (!scene) return scene.take_errors();
    warn_of_exposure(*scene, options_.exposure_ev.value_or(scene->exposure_ev), automatic_exposure);
    const float aspect = aspect_of(options_.request.size);
    Result<scene::Camera> camera = choose_camera(*scene, {options_.scene, options_.camera, aspect});
    if (!camera) return camera.take_errors();
    frame_ = frame_input(options_, *scene, camera_path_ ? scene::camera_at(*camera_path_, 0) : *camera);
    scene_ = std::move(*scene);
    return Unit{};
}

Status SessionOpener::load_probes(const GraphDesc& graph) {
    // With several attempts, a later version of the graph may use the probes even if this version does not.
    const bool may_use =
        attempts_ == Attempts::many || std::ranges::any_of(graph.imports, [](const auto& import) {
            return render::is_probe_import(import.first);
        });
    if (options_.probes == "none" || !may_use) return Unit{};
    Result<FoundProbes> found = find_probes(
        *scene_, {options_.scene, options_.probes, glm::vec3(frame_.camera.transform[3])}, options_.limits);
    if (!found) return found.take_errors();
    probes_ = std::move(found->probes);
    return Unit{};
}

Result<OpenSession> SessionOpener::open_parsed(const ParsedGraph& parsed) {
    const std::vector<std::string> automatic = auto_exposure_params(parsed.desc);
    if (!scene_)
        if (Status s = load_scene(!automatic.empty() && !options_.exposure_ev); !s) return s.take_errors();
    if (!probes_)
        if (Status s = load_probes(parsed.desc); !s) return s.take_errors();
    if (!device_) {
        Result<std::unique_ptr<vk::Device>> device = open_device(options_);
        if (!device) return device.take_errors();
        device_ = std::move(*device);
    }
    Diagnostics warnings;
    render::SessionInput input = input_;
    input.parsed = &parsed;
    if (probes_) input.probes = *probes_;
    // --exposure turns the automatic exposure off. emplace() does not replace a value that --param sets.
    if (options_.exposure_ev)
        for (const std::string& name : automatic) input.request.params.emplace(name, 0);
    Result<std::unique_ptr<render::Session>> session =
        attempts_ == Attempts::one
            ? render::Session::create(*device_, std::move(*scene_), input, warnings, &files_)
            : render::Session::create(*device_, *scene_, input, warnings, &files_);
    if (!options_.quiet) report(warnings);
    if (session) return OpenSession{std::move(device_), frame_, camera_path_, std::move(*session)};
    is_fixable_ = exit_code_for(session.errors()) == ExitCode::invalid_input;
    return session.take_errors();
}

Result<OpenSession> SessionOpener::open() {
    is_fixable_ = false;
    files_.clear();
    if (Status s = expect_scene(options_.scene); !s) return s.take_errors();
    Result<ParsedGraph> parsed = parse_checked();
    if (parsed) return open_parsed(*parsed);
    is_fixable_ = true;
    return parsed.take_errors();
}

Result<OpenSession> open_session(const RenderOptions& options) {
    return SessionOpener(options, SessionOpener::Attempts::one).open();
}

}  // namespace weft::viewer
