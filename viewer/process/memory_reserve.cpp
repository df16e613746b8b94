#include "viewer/process/memory_reserve.h"

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <exception>
#include <new>

#include "viewer/output/report.h"

namespace weft::viewer {
namespace {

// The destructor of a JSON array takes 16 bytes for each value, and as much again while it grows.
constexpr size_t kReserve_bytes = size_t{64} << 20;
constexpr size_t kSmallReserve_bytes = size_t{16} << 20;

void* allocate_reserve() {
    void* memory = std::malloc(kReserve_bytes);
    return memory != nullptr ? memory : std::malloc(kSmallReserve_bytes);
}

// A new-handler has no arguments, so the memory that it frees must be global.
std::atomic<void*>& reserve() {
    static std::atomic<void*> memory = allocate_reserve();  // never written, so it uses no physical
                                                            // memory
    return memory;
}

void release_reserve() {
    std::free(reserve().exchange(nullptr));
    throw std::bad_alloc();
}

// An allocation that fails in a destructor ends the program here. Nothing in this function allocates.
[[noreturn]] void end_with_message() {
    try {
        if (const std::exception_ptr fault = std::current_exception()) std::rethrow_exception(fault);
    } catch (const std::bad_alloc&) {
        report_out_of_memory();
        _exit(static_cast<int>(ExitCode::failed));
    } catch (...) {
    }
    std::abort();
}

}  // namespace

void hold_memory_reserve() {
    reserve();
    std::set_new_handler(release_reserve);
    std::set_terminate(end_with_message);
}

}  // namespace weft::viewer
