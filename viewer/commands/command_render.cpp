#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <optional>

#include "file/write_file.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/session_setup.h"
#include "viewer/commands/swap_run.h"
#include "viewer/commands/verify_rest.h"
#include "viewer/output/output.h"
#include "viewer/output/progress_text.h"
#include "viewer/output/report.h"
#include "viewer/output/stats.h"
#include "viewer/pictures/image_file.h"
#include "weft/render/session.h"
#include "weft/render/texels.h"
#include "weft/vulkan/executor.h"

namespace weft::viewer {
namespace {

// The results of a run: the last picture, the times of the frames, and the last resource that was read back.
struct RunOutcome {
    vk::ReadbackData output;
    std::vector<vk::FrameTiming> warm_up;  // The frames that lit the probes before the first frame.
    std::vector<vk::FrameTiming> timings;
    std::optional<vk::ReadbackData> last_readback;
    std::vector<SwapRecord> swaps;
    Diagnostics swap_errors;  // Of the graphs that --swap could not run.
};

// Prints the number of finished frames to stderr if rendering takes longer than a second. The number does not
// include the last submitted frames, which the device may still be rendering.
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

// Takes the results out of the session after each frame; otherwise the session would use more and more memory
// in a run of many frames. Keeps only the last readback of the observed resource: other readbacks come from
// readback passes of the graph. Keeps times only for --stats.
void collect(render::Session& session, const RenderOptions& options, RunOutcome& outcome) {
    std::vector<vk::FrameTiming> timings = session.take_timings();
    if (!options.stats.empty()) std::ranges::move(timings, std::back_inserter(outcome.timings));
    for (vk::ReadbackData& data : session.take_readbacks())
        if (data.pass.starts_with("observe:")) outcome.last_readback = std::move(data);
}

// Lights the probes before the first frame. If this takes longer than a second, the progress is printed to
// stderr.
Result<std::vector<vk::FrameTiming>> warm_up(render::Session& session, const render::FrameInput& first,
                                             const RenderOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    ProgressText text("lighting probes", isatty(STDERR_FILENO) == 1);
    render::ProbeWarmUp settings{.rounds = options.probe_rounds};
    settings.progress = [&](uint32_t done, uint32_t all) {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
        if (!options.quiet) std::fputs(text.at(elapsed.count(), "turns", done, all).c_str(), stderr);
    };
    Result<std::vector<vk::FrameTiming>> timings = session.warm_up_probes(first, settings);
    std::fputs(text.finish().c_str(), stderr);
    return timings;
}

// Writes the picture of the last frame to a file: the output of the graph, the debug view of --debug, or the
// contents of the resource of --resource. The contents of a buffer are written as raw bytes.
Status write_picture(const std::string& file, const RenderOptions& options, const render::Session& session,
                     const RunOutcome& outcome) {
    const bool is_output = options.resource.empty() && options.request.debug.empty();
    if (!is_output && !outcome.last_readback) {
        Diagnostic d;
        d.code = "W103";
        const std::string& wanted = options.resource.empty() ? options.request.debug : options.resource;
        d.message = "no pass wrote \"" + wanted + "\" in the last frame";
        d.help = {"name a resource that a pass of this graph writes",
                  "or turn on the pass that writes it, if the pass has a \"switch\": --param NAME=1"};
        return d;
    }
    const vk::ReadbackData& data = is_output ? outcome.output : *outcome.last_readback;
    if (data.format == Format::undefined)
        return write_file(file, {reinterpret_cast<const char*>(data.bytes.data()), data.bytes.size()});
    // The output of the graph and the debug views are already encoded for display (sRGB), so the pre-exposure
    // factor is not divided out.
    if (is_output || !options.request.debug.empty()) return write_output_picture(file, data);
    const Result<ImageFileKind> kind = image_file_kind(file);
    if (!kind) return kind.errors();
    std::vector<glm::vec4> texels = render::decode_texels(data.format, data.bytes);
    // The values of a pre-exposed resource are multiplied by the pre-exposure factor. A raw file (EXR, PFM)
    // must contain physical units, so the factor is divided out. A PNG is for viewing: it keeps the factor.
    if (*kind != ImageFileKind::png && is_pre_exposed(session.plan(), options.resource)) {
        for (glm::vec4& texel : texels) texel = glm::vec4(glm::vec3(texel) / session.pre_exposure(), texel.a);
    }
    return write_image(file, data.extent.width, data.extent.height, texels);
}

// Waits for the device, and reads the picture of the last frame.
Status collect_picture(render::Session& session, const RenderOptions& options, RunOutcome& outcome) {
    outcome.last_readback.reset();
    if (Status s = session.finish(); !s) return s;
    if (session.has_output()) {
        Result<vk::ReadbackData> output = session.read_output();
        if (!output) return output.take_errors();
        outcome.output = std::move(*output);
    }
    collect(session, options, outcome);
    return Unit{};
}

// Sets the camera and the time of a frame. `i` is 0 for the first frame.
void advance(render::FrameInput& frame, const std::optional<scene::CameraPath>& path, uint32_t i) {
    const double before_s = frame.time_s;
    frame.time_s = i * frame.delta_time_s;
    if (!path) return;
    frame.camera = scene::camera_at(*path, frame.time_s);
    frame.camera_cut = i > 0 && scene::shot_at(*path, before_s) != scene::shot_at(*path, frame.time_s);
}

// Leaves out the times of frames with earlier graphs, because --stats describes the passes of the last graph.
void keep_last_plan(RunOutcome& outcome, uint32_t frames) {
    const auto last = std::ranges::find_if(outcome.swaps.rbegin(), outcome.swaps.rend(),
                                           [](const SwapRecord& swap) { return !swap.failed; });
    if (last == outcome.swaps.rend()) return;
    outcome.warm_up.clear();
    const size_t kept = std::min(outcome.timings.size(), size_t{frames - (last->frame - 1)});
    outcome.timings.erase(outcome.timings.begin(), outcome.timings.end() - static_cast<ptrdiff_t>(kept));
}

// Renders the frames, and writes the pictures of the last frames: as many as `options` names files.
Result<RunOutcome> run_frames(OpenSession& open, const RenderOptions& options, uint32_t frames) {
    render::Session& session = *open.session;
    render::FrameInput frame = open.frame;
    frame.delta_time_s = options.fixed_dt_s;
    RunOutcome outcome;
    Result<std::vector<vk::FrameTiming>> warm = warm_up(session, frame, options);
    if (!warm) return warm.take_errors();
    outcome.warm_up = std::move(*warm);
    const std::vector<std::string> files =
        options.pictures.empty() ? std::vector{options.output} : options.pictures;
    const uint32_t first_picture = frames - static_cast<uint32_t>(files.size());
    RenderProgress progress(options, frames);
    SwapRun swaps(session, options.swap, options.every);
    for (uint32_t i = 0; i < frames; ++i) {
        if (Status s = swaps.before_frame(i, frames); !s) return s.take_errors();
        advance(frame, open.camera_path, i);
        if (Status s = session.render_frame(frame); !s) return s.take_errors();
        collect(session, options, outcome);
        // The last submitted frames may still be running on the device, so the progress does not count these
        // frames.
        progress.tell(i + 1 - std::min(i + 1, vk::kFramesInFlight));
        if (i < first_picture) continue;
        if (Status s = collect_picture(session, options, outcome); !s) return s.take_errors();
        progress.tell(i + 1);
        if (Status s = write_picture(files[i - first_picture], options, session, outcome); !s)
            return s.take_errors();
    }
    outcome.swaps = swaps.records();
    keep_last_plan(outcome, frames);
    outcome.swap_errors = swaps.errors();
    return outcome;
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

// Reports the errors and returns the exit code. After a time-out or a lost device (ExitCode::lost), the
// device may still use the memory of the process. Then the function ends the process at once, because
// destroying Vulkan objects or unloading the driver is not safe.
ExitCode fail_on_device(const Diagnostics& errors) {
    report(errors);
    const ExitCode code = exit_code_for(errors);
    if (code == ExitCode::lost) std::_Exit(static_cast<int>(code));
    return code;
}

ExitCode run_render(const RenderOptions& given) {
    RenderOptions options = given;
    if (!options.swap.empty()) options.request = swap_request(options.request, options.swap.front());
    // An unknown file extension is an error only for images, not for buffers. With --resource, only the
    // compiled graph tells whether the resource is a buffer, so the check follows after open_session().
    const Result<ImageFileKind> kind = image_file_kind(options.output);
    if (!kind && options.resource.empty()) {
        report(kind.errors());
        return ExitCode::usage;
    }
    std::vector<std::string> outputs = options.pictures;
    outputs.push_back(options.stats);
    if (options.pictures.empty()) outputs.push_back(options.output);
    if (const ExitCode code = check_outputs(outputs, inputs_of(options)); code != ExitCode::ok) return code;
    Result<OpenSession> open = open_session(options);
    if (!open) return fail_on_device(open.errors());
    render::Session& session = *open->session;
    if (const bool shows_output = options.resource.empty() && options.request.debug.empty();
        shows_output && !session.has_output())
        return fail_on_device(session.read_output().errors());
    if (!kind && !is_buffer(session.plan(), options.resource)) {
        report(kind.errors());
        return ExitCode::usage;
    }
    const uint32_t frames = options.frames > 0 ? options.frames : session.frames();
    if (options.verify_rest)
        if (Status s = verify_rest(options, session.plan(), frames); !s) return fail_on_device(s.errors());
    Result<RunOutcome> outcome = run_frames(*open, options, frames);
    if (!outcome) {
        report_messages(open->device->messages().messages());
        return fail_on_device(outcome.errors());
    }
    if (!options.stats.empty()) {
        const std::string json =
            stats_json({*open->device, session.plan(), outcome->output, outcome->timings, frames,
                        session.selection().request.tier, session.pipelines_made_between_frames(),
                        session.probe_count(), outcome->warm_up, outcome->swaps});
        if (Status s = write_file(options.stats, json); !s) return fail_on_device(s.errors());
    }
    const std::string& name = options.named_output.empty() ? options.output : options.named_output;
    if (options.pictures.size() > 1)
        std::fprintf(stderr, "weft: wrote the frames %u to %u to %s\n", options.first_picture, frames,
                     name.c_str());
    else
        std::fprintf(stderr, "weft: wrote %s\n",
                     options.pictures.empty() ? name.c_str() : options.pictures.front().c_str());
    // Destroying the device reports Vulkan objects that still exist, so the session is destroyed first.
    open->session.reset();
    if (report_messages(vk::destroy_device(std::move(open->device)))) return ExitCode::validation;
    return outcome->swap_errors.empty() ? ExitCode::ok : exit_code_for(outcome->swap_errors);
}

}  // namespace weft::viewer
