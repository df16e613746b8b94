// Purpose: reports how far the loading of a scene has come, so that a program can show it.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>

namespace weft::scene {

struct LoadProgress {
    const char* what = "";  // The kind of data that is being loaded, such as "meshes" or "textures".
    uint64_t done = 0;
    uint64_t total = 0;
};

struct LoadOptions {
    uint32_t threads = 0;  // Number of threads that decode images and make mips; 0: one thread per processor.
    // Function that is called after every step. It may be called by any of the threads, but never by two at
    // the same time. May be empty.
    std::function<void(const LoadProgress&)> progress;
};

// Counts the steps of one stage of loading, and reports each. Any thread may call step().
class StageProgress {
 public:
    StageProgress(const LoadOptions& options, const char* what, uint64_t total)
        : options_(options), now_{what, 0, total} {}

    void step() {
        if (!options_.progress) return;
        const std::scoped_lock lock(mutex_);
        ++now_.done;
        options_.progress(now_);
    }

 private:
    const LoadOptions& options_;
    std::mutex mutex_;
    LoadProgress now_;
};

}  // namespace weft::scene
