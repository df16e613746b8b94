#include "viewer/commands/view_start.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "render/file_watch.h"
#include "viewer/commands/session_opener.h"
#include "viewer/output/report.h"

namespace weft::viewer {
namespace {

// Waits until a watched file changes. Returns false if the user ends the command first.
bool wait_for_change(render::FileWatch& watch, EndSignals& end) {
    std::atomic<bool> is_over = false, has_changed = false;
    std::thread waiter([&] {
        while (!is_over && !has_changed) has_changed = watch.wait();
    });
    while (!has_changed && !is_over) is_over = end.within(std::chrono::milliseconds(50));
    if (is_over) watch.wake();
    waiter.join();
    return has_changed;
}

// Returns false if the graph file does not exist. Then its name is probably misspelt, so waiting for an edit
// is useless. An empty name means the shipped graph.
bool is_there(const std::string& graph) {
    std::error_code error;
    return graph.empty() || std::filesystem::is_regular_file(graph, error);
}

}  // namespace

Result<std::optional<OpenSession>> open_when_good(const RenderOptions& options, bool waits, EndSignals& end) {
    SessionOpener opener(options, SessionOpener::Attempts::many);
    Result<std::unique_ptr<render::FileWatch>> watch = render::FileWatch::create();
    if (!watch) return watch.take_errors();
    for (;;) {
        Result<OpenSession> open = opener.open();
        if (open) return std::optional(std::move(*open));
        if (!waits || !opener.is_fixable() || !is_there(options.request.path)) return open.take_errors();
        // watch() returns true if some folders were not watched before. Files there may have been edited
        // since open() read them, so try again.
        if ((*watch)->watch(opener.files())) continue;
        report(open.errors());
        std::fprintf(stderr, "weft: waiting for an edit that corrects the graph\n");
        if (!wait_for_change(**watch, end)) return std::optional<OpenSession>();
    }
}

}  // namespace weft::viewer
