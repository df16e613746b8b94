#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "file/write_file.h"
#include "viewer/commands/commands.h"
#include "viewer/commands/session_setup.h"
#include "viewer/commands/view_start.h"
#include "viewer/output/output.h"
#include "viewer/output/report.h"
#include "viewer/pictures/image_file.h"
#include "viewer/process/end_signals.h"
#include "weft/render/reloader.h"

namespace weft::viewer {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::nanoseconds kFrameTime = std::chrono::nanoseconds(1'000'000'000) / 60;

struct ViewCounts {
    uint64_t frames = 0;
    uint32_t reloads = 0;
    uint32_t failed_reloads = 0;
    double longest_swap_ms = 0;
    // Number of rendered frames when the last picture was written; 0 if none was written.
    uint64_t pictured = 0;
};

// Prints the messages of a reload of the graph. If the edited file has an error, the previous graph keeps
// running.
void tell(const render::Reload& reload, ViewCounts& counts) {
    report(reload.warnings);
    if (!reload.good()) {
        ++counts.failed_reloads;
        report(reload.errors);
        std::fprintf(stderr, "weft: the edit has errors; the last valid graph continues to run\n");
        return;
    }
    ++counts.reloads;
    counts.longest_swap_ms = std::max(counts.longest_swap_ms, reload.swap_ms);
    std::fprintf(stderr, "weft: reloaded in %.0f ms: %s\n", reload.ms, to_text(reload.rebuilt).c_str());
}

Status write_last_frame(const std::string& path, render::Session& session) {
    if (Status s = session.finish(); !s) return s;
    const Result<vk::ReadbackData> data = session.read_output();
    if (!data) return data.errors();
    if (Status s = write_output_picture(path, *data); !s) return s;
    std::fprintf(stderr, "weft: wrote %s\n", path.c_str());
    return Unit{};
}

// Renders frames until the number of --frames is reached or the end is requested. A program with a window
// would display each frame here and handle the events of the window. This loop only waits until the next
// frame is due; with --fixed-dt it does not wait.
Result<ViewCounts> draw_frames(const ViewOptions& options, OpenSession& open, render::Reloader& reloader,
                               EndSignals& end) {
    render::Session& session = *open.session;
    render::FrameInput frame = open.frame;
    ViewCounts counts;
    const Clock::time_point begin = Clock::now();
    bool is_picture_due = true;
    while (options.render.frames == 0 || counts.frames < options.render.frames) {
        const Clock::time_point due = begin + counts.frames * kFrameTime;
        const bool over = end.within(options.fixed_dt ? std::chrono::nanoseconds(0) : due - Clock::now());
        // The loop renders at least one frame before it ends, because --output needs a rendered frame.
        if (over && counts.frames > 0) break;
        if (const std::optional<render::Reload> reload = reloader.update()) {
            tell(*reload, counts);
            is_picture_due |= reload->good();
        }
        const double dt_s = options.render.fixed_dt_s;
        const double now_s = options.fixed_dt ? static_cast<double>(counts.frames) * dt_s
                                              : std::chrono::duration<double>(Clock::now() - begin).count();
        frame.delta_time_s = options.fixed_dt ? dt_s : now_s - frame.time_s;
        frame.time_s = now_s;
        if (Status s = session.render_frame(frame); !s) return s.take_errors();
        // Discard the timings and readbacks: nothing in this loop uses them, and otherwise they would fill
        // the memory.
        static_cast<void>(session.take_timings());
        static_cast<void>(session.take_readbacks());
        ++counts.frames;
        // If a picture cannot be written, rendering continues. Only the write after the last frame decides
        // the exit code.
        if (is_picture_due && !options.render.output.empty()) {
            const Status written = write_last_frame(options.render.output, session);
            if (written) counts.pictured = counts.frames;
            if (!written) report(written.errors());
        }
        is_picture_due = false;
    }
    if (Status s = session.finish(); !s) return s.take_errors();
    return counts;
}

Status write_stats(const std::string& path, const OpenSession& open, const ViewCounts& counts) {
    const nlohmann::ordered_json json{
        {"graph", open.session->selection().request.path},
        {"frames", counts.frames},
        {"reloads", counts.reloads},
        {"failed_reloads", counts.failed_reloads},
        {"longest_swap_ms", counts.longest_swap_ms},
        {"validation", {{"messages", open.device->messages().count()}}},
        {"pipelines_built_on_frame_thread", open.session->pipelines_made_between_frames()},
    };
    return write_file(path, json.dump(2) + "\n");
}

}  // namespace

ExitCode run_view(const ViewOptions& options) {
    if (!options.render.output.empty()) {
        if (const Result<ImageFileKind> kind = image_file_kind(options.render.output); !kind) {
            report(kind.errors());
            return ExitCode::usage;
        }
    }
    if (const ExitCode code =
            check_outputs({options.render.output, options.render.stats}, inputs_of(options.render));
        code != ExitCode::ok)
        return code;
    // Block the signals before other threads are created. Otherwise, another thread could receive the signal
    // and end the program.
    EndSignals end(options.render.frames == 0);
    RenderOptions untimed = options.render;
    // Timing adds barriers to the plan, so it would change the frame that the user looks at.
    untimed.stats.clear();
    // If the command line gives a number of frames, a script probably started the program. Then an error in
    // the graph ends the program. Otherwise, the program waits until the user corrects the file.
    Result<std::optional<OpenSession>> opened = open_when_good(untimed, options.render.frames == 0, end);
    if (!opened) return fail_on_device(opened.errors());
    if (!*opened) return ExitCode::invalid_input;
    OpenSession* open = &**opened;
    Result<std::unique_ptr<render::Reloader>> reloader = render::Reloader::start(*open->session);
    if (!reloader) return fail_on_device(reloader.errors());
    std::fprintf(stderr, "weft: watching %s and the files that it includes\n",
                 open->session->selection().request.path.c_str());
    const Result<ViewCounts> counts = draw_frames(options, *open, **reloader, end);
    reloader->reset();
    if (!counts) {
        report_messages(open->device->messages().messages());
        return fail_on_device(counts.errors());
    }
    if (!options.render.output.empty() && counts->pictured != counts->frames)
        if (Status s = write_last_frame(options.render.output, *open->session); !s)
            return fail_on_device(s.errors());
    if (!options.render.stats.empty())
        if (Status s = write_stats(options.render.stats, *open, *counts); !s)
            return fail_on_device(s.errors());
    open->session.reset();
    return report_messages(vk::destroy_device(std::move(open->device))) ? ExitCode::validation : ExitCode::ok;
}

}  // namespace weft::viewer
