// Purpose: makes errors that have no place in a file.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "weft/result.h"

namespace weft {

// The arguments are the members of Diagnostic with these names.
[[nodiscard]] inline Diagnostic make_error(std::string code, std::string message,
                                           std::vector<std::string> help) {
    Diagnostic error;
    error.code = std::move(code);
    error.message = std::move(message);
    error.help = std::move(help);
    return error;
}

}  // namespace weft
