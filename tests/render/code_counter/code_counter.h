// Purpose: counts the pieces of machine code that llvmpipe has compiled. Each begins as an LLVM module, and
// this library replaces the function that creates modules. A release build of Mesa has no such counter. Code
// loaded from Mesa's disk cache counts too.
#pragma once

#include <cstdint>

namespace weft::test {

// Number since the start of this process. 0 with drivers that do not use LLVM.
[[nodiscard]] uint64_t compiled_modules();

// If WEFT_CODE_COUNT names a file, the count is also kept there: eight bytes, which another process may read
// at any time.
inline constexpr const char* kCodeCountVariable = "WEFT_CODE_COUNT";

}  // namespace weft::test
