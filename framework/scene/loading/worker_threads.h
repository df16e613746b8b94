// Purpose: independent jobs on several threads, with a bound on the memory they have in hand at once. What a
// job leaves in its own place is the same whatever the number of threads; only the order of execution
// differs.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>

namespace weft::scene {

// Runs job(0) to job(count - 1), in this order but side by side, on `threads` threads, the caller's among
// them; 0 threads: as many as the machine has. Returns when all are done. Jobs must not throw.
void run_on_threads(size_t count, uint32_t threads, const std::function<void(size_t)>& job);

// Bytes that jobs take before they work and give back after: whoever would exceed the limit waits, unless
// nobody else holds any.
class ByteBudget {
 public:
    explicit ByteBudget(uint64_t limit_bytes) : limit_bytes_(limit_bytes) {}

    class Share {
     public:
        Share(ByteBudget& budget, uint64_t bytes);
        ~Share();
        Share(const Share&) = delete;
        Share& operator=(const Share&) = delete;

     private:
        ByteBudget& budget_;
        uint64_t bytes_;
    };

 private:
    const uint64_t limit_bytes_;
    uint64_t taken_bytes_ = 0;
    std::mutex mutex_;
    std::condition_variable given_back_;
};

}  // namespace weft::scene
