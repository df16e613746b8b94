// Purpose: finds the name at the beginning of a reference, to expand shorthand notation before the references
// are parsed.
#pragma once

#include <string>
#include <string_view>

namespace weft {

// Returns the name of the resource in a reference, for example "hiz" for "hiz@build.mip(0)".
[[nodiscard]] inline std::string reference_name(std::string_view text) {
    return std::string(text.substr(0, text.find_first_of("@[.")));
}

}  // namespace weft
