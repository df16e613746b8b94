#include "scene/loading/worker_threads.h"

#include <algorithm>
#include <atomic>
#include <system_error>
#include <thread>
#include <vector>

namespace weft::scene {

void run_on_threads(size_t count, uint32_t threads, const std::function<void(size_t)>& job) {
    std::atomic<size_t> next = 0;
    const auto work = [&] {
        for (size_t i = next++; i < count; i = next++) job(i);
    };
    if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::jthread> others;
    for (size_t i = 1; i < std::min<size_t>(threads, count); ++i) {
        try {
            others.emplace_back(work);
        } catch (const std::system_error&) {
            break;  // The system cannot create more threads: the existing threads do the remaining jobs.
        }
    }
    work();
}

ByteBudget::Share::Share(ByteBudget& budget, uint64_t bytes) : budget_(budget), bytes_(bytes) {
    std::unique_lock lock(budget_.mutex_);
    budget_.given_back_.wait(lock, [&] {
        return budget_.taken_bytes_ == 0 || budget_.taken_bytes_ + bytes_ <= budget_.limit_bytes_;
    });
    budget_.taken_bytes_ += bytes_;
}

ByteBudget::Share::~Share() {
    {
        const std::scoped_lock lock(budget_.mutex_);
        budget_.taken_bytes_ -= bytes_;
    }
    budget_.given_back_.notify_all();
}

}  // namespace weft::scene
