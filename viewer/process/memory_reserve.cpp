#include "viewer/process/memory_reserve.h"

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <exception>
#include <new>

#include "viewer/output/report.h"

namespace weft::viewer {
namespace {

// Size of the memory reserve, and the smaller size that is used if the first one cannot be allocated. The
// size is chosen for the destruction of large JSON values after an error. The destructor of a JSON array
// moves its elements to a temporary list. This list needs 16 bytes for each element, and more while it grows.
constexpr size_t kReserve_bytes = size_t{64} << 20;
constexpr size_t kSmallReserve_bytes = size_t{16} << 20;

void* allocate_reserve() {
    void* memory = std::malloc(kReserve_bytes);
    return memory != nullptr ? memory : std::malloc(kSmallReserve_bytes);
}

// Returns the pointer to the reserve. The pointer is global, because a new-handler has no arguments and must
// be able to free the reserve.
std::atomic<void*>& reserve() {
    // The reserve is never written, so it uses no physical memory.
    static std::atomic<void*> memory = allocate_reserve();
    return memory;
}

void release_reserve() {
    std::free(reserve().exchange(nullptr));
    throw std::bad_alloc();
}

// Handles std::terminate(), which is called when an exception leaves a destructor. If the exception is
// std::bad_alloc, the function prints the error X571 and exits; otherwise it aborts. It allocates no memory
// itself.
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
