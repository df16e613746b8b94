#include "viewer/process/memory_reserve.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace weft::viewer {
namespace {

constexpr size_t kReserve_bytes = size_t{16} << 20;

// A new-handler has no arguments, so the memory that it frees must be global.
std::atomic<void*>& reserve() {
    static std::atomic<void*> memory = std::malloc(kReserve_bytes);  // never written, so it uses no physical
                                                                     // memory
    return memory;
}

void release_reserve() {
    std::free(reserve().exchange(nullptr));
    throw std::bad_alloc();
}

}  // namespace

void hold_memory_reserve() {
    reserve();
    std::set_new_handler(release_reserve);
}

}  // namespace weft::viewer
