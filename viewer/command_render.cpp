#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "commands.h"
#include "file/write_file.h"
#include "files.h"
#include "graph/debug_view.h"
#include "image_file.h"
#include "output.h"
#include "progress_text.h"
#include "render/import_catalog.h"
#include "render/session.h"
#include "render/texels.h"
#include "scene_source.h"
#include "session_setup.h"
#include "shader/load_graph.h"
#include "stats.h"
#include "vulkan/executor.h"
#include "weft/registry.h"

namespace weft::viewer {
namespace {

// What is left of a run once the frames are done.
struct RunOutcome {
    vk::ReadbackData output;
    std::vector<vk::FrameTiming> timings;
    std::vector<vk::ReadbackData> readbacks;
};

// On stderr, once it takes longer than a moment. The device is some frames behind what is told.
class RenderProgress {
 public:
    RenderProgress(const RenderOptions& options, uint32_t frames)
        : text_("rendering", isatty(STDERR_FILENO) == 1), frames_(frames), is_quiet_(options.quiet) {}
    ~RenderProgress() { std::fputs(text_.finish().c_str(), stderr); }
    RenderProgress(const RenderProgress&) = delete;
    RenderProgress& operator=(const RenderProgress&) = delete;

    void tell(uint32_t done) {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
        if (!is_quiet_) std::fputs(text_.at(elapsed.count(), "frames", done, frames_).c_str(), stderr);
    }

 private:
    ProgressText text_;
    uint32_t frames_;
    bool is_quiet_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

Result<RunOutcome> run_frames(render::Session& session, const RenderOptions& options, uint32_t frames) {
    RenderProgress progress(options, frames);
    for (uint32_t i = 0; i < frames; ++i) {
        if (Status s = session.render_frame(i * options.fixed_dt_s, options.fixed_dt_s); !s)
            return s.take_errors();
        // Of those that are begun the last ones may still be drawn.
        progress.tell(i + 1 - std::min(i + 1, vk::kFramesInFlight));
    }
    if (Status s = session.finish(); !s) return s.take_errors();
    progress.tell(frames);
    Result<vk::ReadbackData> output = session.read_output();
    if (!output) return output.take_errors();
    return RunOutcome{std::move(*output), session.take_timings(), session.take_readbacks()};
}

// The picture that --output asks for: the graph's output, or the resource of --resource.
Status write_picture(const RenderOptions& options, const render::Session& session,
                     const RunOutcome& outcome) {
    const bool is_output = options.resource.empty() && options.debug.empty();
    if (!is_output && outcome.readbacks.empty()) {
        Diagnostic d;
        d.code = "W103";
        d.message = "\"" + options.resource + "\" was not read back";
        d.help = {"name a resource that a pass of this graph writes"};
        return d;
    }
    const vk::ReadbackData& data = is_output ? outcome.output : outcome.readbacks.back();
    if (data.format == Format::undefined)
        return write_file(options.output,
                          {reinterpret_cast<const char*>(data.bytes.data()), data.bytes.size()});
    // Both are ready for a display.
    if (is_output || !options.debug.empty()) return write_output_picture(options.output, data);
    const Result<ImageFileKind> kind = image_file_kind(options.output);
    if (!kind) return kind.errors();
    std::vector<glm::vec4> texels = render::decode_texels(data.format, data.bytes);
    // Raw values are in the resource's own units; a PNG is for looking at, so it keeps the exposure.
    if (*kind != ImageFileKind::png && is_pre_exposed(session.plan(), options.resource)) {
        for (glm::vec4& texel : texels) texel = glm::vec4(glm::vec3(texel) / session.pre_exposure(), texel.a);
    }
    return write_image(options.output, data.extent.width, data.extent.height, texels);
}

// The environment is in cd/m²; how much of that makes a white pixel, the exposure says.
void warn_of_exposure(const scene::Scene& scene, float exposure_ev) {
    constexpr float kMiddleGrey = 0.18f, kMostStops = 6;
    const float mean = mean_luminance(scene.environment);
    if (mean <= 0) return;
    const float stops = std::log2(mean / kMiddleGrey) + exposure_ev;
    if (std::abs(stops) <= kMostStops) return;
    Diagnostic d;
    d.code = "S182";
    d.severity = Severity::warning;
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(), "%.0f stops too %s for the exposure of %g EV", std::abs(stops),
                  stops < 0 ? "dark" : "bright", exposure_ev);
    d.message = "the environment \"" + scene.environment.name + "\" is " + text.data();
    std::snprintf(text.data(), text.size(), "its values are taken as cd/m²: --exposure %.1f shows it",
                  exposure_ev - stops);
    d.help = {text.data()};
    report({d});
}

}  // namespace

render::SessionInput session_input(const RenderOptions& options, const scene::Scene& scene,
                                   const scene::Camera& camera, const PassCatalog& passes) {
    const std::filesystem::path root = shipped_root();
    render::SessionInput input;
    input.graph_path = options.graph.empty() ? (root / "graphs" / "deferred.json").string() : options.graph;
    input.reader = reader_up_to(options.limits.graph.json_bytes);
    input.shader_root = root / "shaders";
    input.shader_cache = shader_cache();
    input.shader_worker = find_shader_worker();
    input.limits = options.limits;
    input.passes = &passes;
    input.size = options.size;
    input.graph_root = root / "graphs";
    input.tier = options.tier;
    input.params = options.params;
    input.observed = options.observed;
    if (!options.resource.empty()) input.observed.push_back(options.resource);
    input.debug = options.debug;
    if (!options.debug.empty()) input.observed.emplace_back(kDebugView);
    input.camera = camera;
    input.exposure_ev = options.exposure_ev.value_or(scene.exposure_ev);
    input.queues = options.queues;
    input.check_plan = options.validate;
    input.timestamps = !options.stats.empty() && !options.validate;
    input.drop_barriers_before = options.drop_barriers_before;
    return input;
}

Result<std::unique_ptr<vk::Device>> open_device(const RenderOptions& options) {
    vk::DeviceOptions device_options;
    device_options.validate = options.validate;
    device_options.device = options.device;
    device_options.queues = options.queues;
    device_options.timeout_ns = static_cast<uint64_t>(options.timeout_s * 1e9);
    return vk::Device::create(device_options);
}

namespace {

// Before a scene is loaded and a device made: both take their time.
Status check_graph(const RenderOptions& options, const PassCatalog& passes) {
    const render::SessionInput session = session_input(options, {}, {}, passes);
    const ImportCatalog imports = render::scene_imports(options.size);
    const DeviceProfile profile;
    return check_request({.path = session.graph_path,
                          .reader = session.reader,
                          .shader_root = session.shader_root,
                          .shader_cache = {},
                          .passes = passes,
                          .imports = imports,
                          .profile = profile,
                          .params = options.params,
                          .limits = options.limits,
                          .graph_root = session.graph_root,
                          .tier = options.tier,
                          .debug = options.debug});
}

}  // namespace

Status write_output_picture(const std::string& path, const vk::ReadbackData& data) {
    const Result<ImageFileKind> kind = image_file_kind(path);
    if (!kind) return kind.errors();
    if (*kind == ImageFileKind::png)
        return write_png(path, data.extent.width, data.extent.height, data.bytes);
    return write_image(path, data.extent.width, data.extent.height,
                       render::decode_texels(data.format, data.bytes));
}

bool report_messages(const std::vector<vk::Message>& messages) {
    for (const vk::Message& message : messages)
        std::fprintf(stderr, "validation: %s%s%s: %s\n", message.id.c_str(),
                     message.pass.empty() ? "" : ": pass ", message.pass.c_str(), message.text.c_str());
    return !messages.empty();
}

// After a time-out the device may still be at work with our memory: leaving is safe, tearing things down
// under it, the driver among them, is not.
ExitCode fail_on_device(const Diagnostics& errors) {
    report(errors);
    const ExitCode code = exit_code_for(errors);
    if (code == ExitCode::lost) std::_Exit(static_cast<int>(code));
    return code;
}

Result<OpenSession> open_session(const RenderOptions& options) {
    const PassCatalog passes = registered_passes();
    if (Status s = check_graph(options, passes); !s) return s.take_errors();
    Diagnostics warnings;
    Result<scene::Scene> scene =
        open_scene({options.scene, options.env, options.hour, options.lights, options.seed},
                   options.limits.scene, warnings);
    if (!options.quiet) report(warnings);
    if (!scene) return scene.take_errors();
    warn_of_exposure(*scene, options.exposure_ev.value_or(scene->exposure_ev));
    const float aspect = static_cast<float>(options.size.width) / static_cast<float>(options.size.height);
    Result<scene::Camera> camera = choose_camera(*scene, options.camera, aspect);
    if (!camera) return camera.take_errors();

    Result<std::unique_ptr<vk::Device>> device = open_device(options);
    if (!device) return device.take_errors();

    warnings.clear();
    Result<std::unique_ptr<render::Session>> session =
        render::Session::create(**device, *scene, session_input(options, *scene, *camera, passes), warnings);
    if (!options.quiet) report(warnings);
    if (!session) return session.take_errors();
    return OpenSession{std::move(*device), std::move(*session)};
}

ExitCode run_render(const RenderOptions& options) {
    if (const Result<ImageFileKind> kind = image_file_kind(options.output);
        !kind && options.resource.empty()) {
        report(kind.errors());
        return ExitCode::usage;
    }
    if (const ExitCode code = check_outputs({options.output, options.stats}); code != ExitCode::ok)
        return code;
    Result<OpenSession> open = open_session(options);
    if (!open) return fail_on_device(open.errors());
    render::Session& session = *open->session;
    const uint32_t frames = options.frames > 0 ? options.frames : session.frames();
    Result<RunOutcome> outcome = run_frames(session, options, frames);
    if (!outcome) {
        report_messages(open->device->messages().messages());
        return fail_on_device(outcome.errors());
    }
    if (Status s = write_picture(options, session, *outcome); !s) return fail_on_device(s.errors());
    if (!options.stats.empty()) {
        const std::string json =
            stats_json({*open->device, session.plan(), outcome->output, outcome->timings, frames});
        if (Status s = write_file(options.stats, json); !s) return fail_on_device(s.errors());
    }
    std::fprintf(stderr, "weft: wrote %s\n", options.output.c_str());
    // Objects that are still alive are heard of only when the device goes.
    open->session.reset();
    return report_messages(vk::destroy_device(std::move(open->device))) ? ExitCode::validation : ExitCode::ok;
}

}  // namespace weft::viewer
