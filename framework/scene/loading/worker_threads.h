// Purpose: runs independent jobs on several threads, with a limit on the memory that these jobs use at the
// same time. The number of threads changes only the order of execution, not the result of a job.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>

namespace weft::scene {

// Runs job(0) to job(count - 1) in parallel and starts them in this order. Uses at most `threads` threads,
// including the caller's thread; 0 means one thread per processor. Returns when all jobs are done. Jobs must
// not throw.
void run_on_threads(size_t count, uint32_t threads, const std::function<void(size_t)>& job);

// A limit on the temporary memory of all jobs together. A job creates a Share before it allocates its memory;
// the destructor of the Share returns the bytes. A job that would exceed the limit waits until enough bytes
// are returned. A job that needs more than the whole limit waits until no other job holds bytes, and then
// runs alone.
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
