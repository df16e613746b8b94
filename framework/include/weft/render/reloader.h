// Purpose: reloads the graph of a session when its files change. A thread waits for changes of the graph, its
// shaders and their includes, and prepares the changed graph. The frame thread takes it over between two
// frames. While the files have faults, the last valid graph keeps running. Errors: X580 the system provides
// no watch. Warnings: X581 a folder of the files cannot be watched.
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
    Rebuilt rebuilt;       // if there was no error
    Diagnostics errors;    // the reasons why the old graph keeps running
    Diagnostics warnings;  // of the new graph
    double ms = 0;         // from the end of the change to the swap
    double swap_ms = 0;    // the part of `ms` on the frame thread

    [[nodiscard]] bool good() const { return errors.empty(); }
};

class Reloader {
 public:
    // `session` must outlive the reloader. Changes since the session loaded its files are noticed, too.
    [[nodiscard]] static Result<std::unique_ptr<Reloader>> start(Session& session);
    ~Reloader();
    Reloader(const Reloader&) = delete;
    Reloader& operator=(const Reloader&) = delete;

    // Call it on the frame thread, between two frames: swaps to the prepared graph, if there is one. Never
    // waits.
    [[nodiscard]] std::optional<Reload> update();
    // Swaps to another graph, tier or other parameters; works like a change of a file.
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
    // Makes the thread prepare again although no file changed.
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
