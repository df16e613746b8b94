// Purpose: measures the time of each stage of compile() if the caller asked for it.
#pragma once

#include <chrono>
#include <vector>

#include "weft/compile.h"

namespace weft {

class StageTimer {
 public:
    explicit StageTimer(std::vector<StageTime>* times) : times_(times) {
        if (times_ != nullptr) times_->clear();
    }

    // Records the time since the end of the previous stage as the time of stage `name`. `result` is the
    // result of the stage and is returned unchanged. So the caller can write stage("cull", cull(...)) where
    // it would otherwise write cull(...).
    template <class T>
    [[nodiscard]] T stage(const char* name, T result) {
        if (times_ == nullptr) return result;
        const Clock::time_point now = Clock::now();
        times_->push_back({name, std::chrono::duration<double, std::micro>(now - start_).count()});
        start_ = Clock::now();
        return result;
    }

 private:
    using Clock = std::chrono::steady_clock;

    std::vector<StageTime>* times_;
    Clock::time_point start_ = Clock::now();
};

}  // namespace weft
