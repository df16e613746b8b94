// Purpose: keeps a session's picture up to date with its files. A thread waits for the graph, what it
// includes, its shaders and what those include, prepares what changed, and leaves it for the frame thread,
// which takes it over between two frames. Whatever is wrong with the files, the last good graph goes on.
// Units: milliseconds in names. Errors: X580 files can't be watched; warning X581, a
// folder of theirs can't.
#pragma once

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "weft/render/file_watch.h"
#include "weft/render/session.h"

namespace weft::render {

// What came of a change of files.
struct Reload {
    Rebuilt rebuilt;       // when there are no errors
    Diagnostics errors;    // why the graph that ran before goes on
    Diagnostics warnings;  // of the graph as it is now
    double ms = 0;         // from the end of the change to the swap
    double swap_ms = 0;    // of that, on the frame thread

    [[nodiscard]] bool good() const { return errors.empty(); }
};

class Reloader {
 public:
    // `session` outlives it. What changed since the session loaded its files is noticed.
    [[nodiscard]] static Result<std::unique_ptr<Reloader>> start(Session& session);
    ~Reloader();
    Reloader(const Reloader&) = delete;
    Reloader& operator=(const Reloader&) = delete;

    // On the frame thread, between two frames: takes over what is ready, if anything is. Never waits.
    [[nodiscard]] std::optional<Reload> update();
    // Swaps to another graph, tier or other parameters, as if a file had said so.
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
    // To prepare again, though no file changed.
    void ask_again();

    Session& session_;
    const std::unique_ptr<FileWatch> watch_;
    std::set<std::filesystem::path> good_files_;  // of the last load that succeeded; the thread's own
    std::mutex mutex_;                            // of all below
    Selection selection_;
    bool asked_ = false;
    bool stop_ = false;
    std::optional<Ready> ready_;
    std::thread thread_;
};

}  // namespace weft::render
