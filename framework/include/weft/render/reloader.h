// Purpose: keeps a session's picture up to date with its files. A thread waits for changes of the graph, its
// shaders and their includes, and prepares the changed graph. The frame thread takes it over between two
// frames. While the files have faults, the last good graph goes on. Errors: X580 the system gives no watch.
// Warnings: X581 a folder of the files can't be watched.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

#include "weft/render/session.h"

namespace weft::render {

class FileWatch;

// The result of a change of files.
struct Reload {
    Rebuilt rebuilt;       // without errors
    Diagnostics errors;    // why the old graph goes on
    Diagnostics warnings;  // of the new graph
    double ms = 0;         // from the end of the change to the swap
    double swap_ms = 0;    // of that, on the frame thread

    [[nodiscard]] bool good() const { return errors.empty(); }
};

class Reloader {
 public:
    // `session` outlives it. Changes since the session loaded its files are noticed, too.
    [[nodiscard]] static Result<std::unique_ptr<Reloader>> start(Session& session);
    ~Reloader();
    Reloader(const Reloader&) = delete;
    Reloader& operator=(const Reloader&) = delete;

    // On the frame thread, between two frames: swaps to the graph that is ready, if there is one. Never
    // waits.
    [[nodiscard]] std::optional<Reload> update();
    // Swaps to another graph, tier or other parameters, as after a change of a file.
    void select(const Selection& selection);

 private:
    using Clock = std::chrono::steady_clock;
    struct Ready {
        PrepareResult made;
        Clock::time_point begun;
    };
    Reloader(Session& session, std::unique_ptr<FileWatch> watch);
    void run();
    [[nodiscard]] bool wait_for_work();
    [[nodiscard]] PrepareResult prepare_and_watch(const Selection& selection);
    // Makes the thread prepare again, though no file changed.
    void ask_again();

    Session& session_;
    const std::unique_ptr<FileWatch> watch_;
    std::set<std::filesystem::path> good_files_;  // files of the last successful load; used only by the
                                                  // watching thread
    std::mutex mutex_;                            // guards all members below
    Selection selection_;
    bool asked_ = false;
    bool stop_ = false;
    std::optional<Ready> ready_;
    std::thread thread_;
};

}  // namespace weft::render
