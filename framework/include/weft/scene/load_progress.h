// Purpose: the progress of loading a scene, for display.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>

namespace weft::scene {

struct LoadProgress {
    const char* what = "";  // "meshes", "textures"
    uint64_t done = 0;
    uint64_t total = 0;
};

struct LoadOptions {
    uint32_t threads = 0;  // number of threads that decode images and make mips; 0: one per processor
    // Called after every step, from any of the threads, but never by two at once. May be empty.
    std::function<void(const LoadProgress&)> progress;
};

// Counts the steps of one stage; may be called from any thread.
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
