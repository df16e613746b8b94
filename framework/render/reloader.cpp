#include "weft/render/reloader.h"

#include "render/file_watch.h"
#include "render/swap_parts.h"

namespace weft::render {
namespace {

double ms_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

Diagnostic unseen_changes(const std::filesystem::path& folder) {
    Diagnostic warning;
    warning.severity = Severity::warning;
    warning.code = "X581";
    warning.message =
        "the folder \"" + folder.string() + "\" cannot be watched, so edits of its files are not noticed";
    warning.help = {"make the folder readable, or raise fs.inotify.max_user_watches"};
    return warning;
}

}  // namespace

Reloader::Reloader(Session& session, std::unique_ptr<FileWatch> watch)
    : session_(session),
      watch_(std::move(watch)),
      good_files_(session.first_files()),
      selection_(session.selection()) {}

Result<std::unique_ptr<Reloader>> Reloader::start(Session& session) {
    Result<std::unique_ptr<FileWatch>> watch = FileWatch::create();
    if (!watch) return watch.take_errors();
    std::unique_ptr<Reloader> reloader(new Reloader(session, std::move(*watch)));
    reloader->thread_ = std::thread([self = reloader.get()] { self->run(); });
    return reloader;
}

Reloader::~Reloader() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    watch_->wake();
    thread_.join();
}

// Prepares the graph that replaces the running one, and watches the files from which it is loaded. A file
// that is read before its folder is watched may change in between. So the files are read again after new
// folders are watched; results that are still valid are reused.
PrepareResult Reloader::prepare_and_watch(const Selection& selection) {
    constexpr int kMostRounds = 4;
    PrepareResult made = session_.prepare(selection);
    for (int round = 0; round < kMostRounds; ++round) {
        // After an error, the load may have stopped before it reached all files. So the files of the last
        // successful load are watched too.
        std::set<std::filesystem::path> files = made.files;
        if (made.result)
            good_files_ = made.files;
        else
            files.insert(good_files_.begin(), good_files_.end());
        if (!watch_->watch(files)) break;
        PrepareResult again = session_.prepare(selection);
        if (made.result && again.result)
            again.result->parts().rebuilt.made_pipelines += made.result->rebuilt().made_pipelines;
        made = std::move(again);
    }
    for (const std::filesystem::path& folder : watch_->unwatched())
        made.warnings.push_back(unseen_changes(folder));
    return made;
}

void Reloader::run() {
    bool first = true;
    for (;;) {
        Selection selection;
        {
            const std::lock_guard lock(mutex_);
            if (stop_) return;
            asked_ = false;
            selection = selection_;
        }
        const Clock::time_point begun = Clock::now();
        PrepareResult made = prepare_and_watch(selection);
        const bool worth_telling =
            !first || !made.result || !made.result->rebuilt().nothing() || !watch_->unwatched().empty();
        first = false;
        // Declared outside the lock's scope, so that the replaced result is destroyed after the lock is
        // released.
        std::optional<Ready> stale;
        {
            const std::lock_guard lock(mutex_);
            if (stop_) return;
            if (worth_telling) {
                stale = std::move(ready_);
                ready_ = Ready{std::move(made), begun};
            }
            if (asked_) continue;
        }
        if (!wait_for_work()) return;
    }
}

// Waits until files change, or select() or ask_again() is called. Returns false if the thread must end.
bool Reloader::wait_for_work() {
    for (;;) {
        const bool changed = watch_->wait();
        const std::lock_guard lock(mutex_);
        if (stop_) return false;
        if (changed || asked_) return true;
    }
}

std::optional<Reload> Reloader::update() {
    std::optional<Ready> ready;
    {
        const std::lock_guard lock(mutex_);
        ready = std::exchange(ready_, std::nullopt);
    }
    if (!ready) return std::nullopt;
    Reload reload;
    reload.warnings = std::move(ready->made.warnings);
    if (!ready->made.result) {
        reload.errors = ready->made.result.take_errors();
    } else {
        const Clock::time_point begin = Clock::now();
        reload.rebuilt = ready->made.result->rebuilt();
        Result<bool> swapped = session_.swap_in(std::move(*ready->made.result));
        if (!swapped)
            reload.errors = swapped.take_errors();
        else if (!*swapped) {
            ask_again();
            return std::nullopt;
        }
        reload.swap_ms = ms_since(begin);
    }
    reload.ms = ms_since(ready->begun);
    return reload;
}

void Reloader::select(const Selection& selection) {
    {
        const std::lock_guard lock(mutex_);
        selection_ = selection;
        asked_ = true;
    }
    watch_->wake();
}

void Reloader::ask_again() {
    {
        const std::lock_guard lock(mutex_);
        // The session may have been resized after the last select(). So the session's size and output are
        // used.
        selection_.request.size = session_.selection().request.size;
        selection_.output = session_.selection().output;
        asked_ = true;
    }
    watch_->wake();
}

}  // namespace weft::render
