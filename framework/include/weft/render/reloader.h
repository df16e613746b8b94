// Purpose: keeps a session's picture up to date with its files. A thread watches the graph, its included
// files, its shaders and their included files, prepares changed parts, and stores the result for the frame
// thread, which takes it between two frames. If the files have faults, the last valid graph keeps running.
// Units: milliseconds in names. Errors: X580 files cannot be watched; warning X581, one of their folders
// cannot be watched.
#pragma once

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "weft/render/file_watch.h"
#include "weft/render/session.h"

namespace weft::render {

// The result of a change of files.
struct Reload {
    Rebuilt rebuilt;       // valid if there are no errors
    Diagnostics errors;    // the reasons why the previous graph keeps running
    Diagnostics warnings;  // warnings about the current graph
    double ms = 0;         // time from the end of the change to the swap
    double swap_ms = 0;    // the part of this time on the frame thread

    [[nodiscard]] bool good() const { return errors.empty(); }
};

class Reloader {
 public:
    // `session` must outlive this. Changes since the session loaded its files are noticed.
    [[nodiscard]] static Result<std::unique_ptr<Reloader>> start(Session& session);
    ~Reloader();
    Reloader(const Reloader&) = delete;
    Reloader& operator=(const Reloader&) = delete;

    // Call this on the frame thread, between two frames: takes over a prepared change, if there is one. Never
    // waits.
    [[nodiscard]] std::optional<Reload> update();
    // Swaps to another graph, tier or other parameters, as after a change of a file.
    void select(const Selection& selection);

 private:
    using Clock = std::chrono::steady_clock;
    struct Ready {
        Preparation made;
        Clock::time_point begun;
    };
    Reloader(Session& session, std::unique_ptr<FileWatch> watch)
        : session_(session),
          watch_(std::move(watch)),
          good_files_(session.first_files()),
          selection_(session.selection()) {}
    void run();
    [[nodiscard]] bool wait_for_work();
    [[nodiscard]] Preparation prepare_and_watch(const Selection& selection);
    // Requests another preparation although no file changed.
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
