// Purpose: how many pieces of machine code llvmpipe has compiled. Each begins as a module of LLVM, and this library
// stands in front of the function that makes one. A release build of Mesa tells nothing about that by itself. Pieces
// that come out of Mesa's cache on the disk count as well.
#pragma once

#include <cstdint>

namespace weft::test {

// In this process, since it began. 0 with drivers that do without LLVM.
[[nodiscard]] uint64_t compiled_modules();

// Where WEFT_CODE_COUNT names a file, the count is kept there as well: eight bytes, which another process may read at
// any time.
inline constexpr const char* kCodeCountVariable = "WEFT_CODE_COUNT";

}  // namespace weft::test
