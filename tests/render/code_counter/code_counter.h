// Purpose: counts the pieces of machine code that llvmpipe has compiled, because a release build of Mesa has
// no such counter. Each piece begins as an LLVM module, and this library replaces the LLVM function that
// creates modules. Code loaded from Mesa's disk cache counts too.
#pragma once

#include <cstdint>

namespace weft::test {

// Returns the number of LLVM modules that the driver created since the start of this process. The number is 0
// with drivers that do not use LLVM.
[[nodiscard]] uint64_t compiled_modules();

// Name of an environment variable. If the variable contains the name of a file, the count is kept in the
// first eight bytes of that file, and continues from the number in an existing file. Another process may read
// these bytes at any time.
inline constexpr const char* kCodeCountVariable = "WEFT_CODE_COUNT";

}  // namespace weft::test
