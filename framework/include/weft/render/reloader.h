// Purpose: reloads the graph of a session when its files change. A thread waits for changes of the graph, its
// shaders and their includes, and prepares the changed graph. Between two frames, the frame thread swaps to
// the prepared graph. While the files have faults, the last valid graph keeps running. Errors: X580 the
// system cannot watch files. Warnings: X581 a folder cannot be watched.
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

// The result of reloading after a change of files.
struct Reload {
    Rebuilt rebuilt;       // The parts that were made again, if there was no error.
    Diagnostics errors;    // The reasons why the old graph keeps running; empty if the new graph runs.
    Diagnostics warnings;  // The warnings about the new graph.
    double ms = 0;         // Time in milliseconds from the start of the preparation to the end of the swap.
    double swap_ms = 0;    // The part of `ms` that the frame thread spent.

    [[nodiscard]] bool good() const { return errors.empty(); }
};

class Reloader {
 public:
    // Starts a reloader. `session` must outlive it. Changes of files since the session loaded them are
    // noticed, too.
    [[nodiscard]] static Result<std::unique_ptr<Reloader>> start(Session& session);
    ~Reloader();
    Reloader(const Reloader&) = delete;
    Reloader& operator=(const Reloader&) = delete;

    // Swaps to the prepared graph and returns the result. Returns nullopt if no preparation has finished
    // since the last call, or if the graph must be prepared again. Call this on the frame thread, between two
    // frames. It never waits for a preparation.
    [[nodiscard]] std::optional<Reload> update();
    // Selects another graph, tier or other parameters. The graph is prepared and swapped in as after a change
    // of a file.
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
    // Makes the thread prepare the graph again, although no file has changed.
    void ask_again();

    Session& session_;
    const std::unique_ptr<FileWatch> watch_;
    // The files of the last successful load. Only the watching thread uses this member.
    std::set<std::filesystem::path> good_files_;
    // Guards the members from selection_ to ready_, which the watching thread and the frame thread use.
    std::mutex mutex_;
    Selection selection_;
    bool asked_ = false;
    bool stop_ = false;
    std::optional<Ready> ready_;
    std::thread thread_;
};

}  // namespace weft::render
