#include "tests/render/code_counter/code_counter.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace weft::test {
namespace {

constexpr const char* kFunction = "LLVMModuleCreateWithNameInContext";
using MakeModule = void* (*)(const char*, void*);

using Count = std::atomic<uint64_t>;
static_assert(sizeof(Count) == 8 && Count::is_always_lock_free);

Count* count_in_file() {
    const char* name = std::getenv(kCodeCountVariable);
    const int file = name == nullptr ? -1 : open(name, O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (file < 0) return nullptr;
    void* memory = MAP_FAILED;
    if (ftruncate(file, sizeof(Count)) == 0)
        memory = mmap(nullptr, sizeof(Count), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    close(file);
    return memory == MAP_FAILED ? nullptr : static_cast<Count*>(memory);
}

Count& count() {
    static Count in_memory = 0;
    static Count* const in_file = count_in_file();
    return in_file != nullptr ? *in_file : in_memory;
}

// Finds the function of LLVM that this library replaces (kFunction), so that it can be called after counting.
// `caller` is an address in the driver that called the replacement. Each driver in the process may have its
// own copy of LLVM, so the search covers only this driver and the libraries that it depends on.
MakeModule find_real(void* caller) {
    Dl_info driver{};
    void* library =
        dladdr(caller, &driver) == 0 ? nullptr : dlopen(driver.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
    void* function = library == nullptr ? nullptr : dlsym(library, kFunction);
    if (function == nullptr) {
        std::fprintf(stderr, "code counter: no LLVM to call\n");
        std::abort();
    }
    // Releases only the reference that dlopen() has added. The driver itself keeps the library loaded.
    dlclose(library);
    return reinterpret_cast<MakeModule>(function);
}

}  // namespace

uint64_t compiled_modules() {
    return count();
}

}  // namespace weft::test

// Counts a module and calls LLVM's function. The driver calls this function instead of LLVM's own, because
// the dynamic linker searches this library before LLVM.
extern "C" __attribute__((visibility("default"))) void* LLVMModuleCreateWithNameInContext(const char* name,
                                                                                          void* context) {
    ++weft::test::count();
    return weft::test::find_real(__builtin_return_address(0))(name, context);
}
