// Purpose: finds the name at the beginning of a reference, to expand shorthand notation before the references
// are parsed.
#pragma once

#include <string>
#include <string_view>

namespace weft {

// Returns the name of the resource in a reference, for example "hiz" for "hiz@build.mip(0)". The name of a
// group is left out: "raw" for "relight::raw".
[[nodiscard]] inline std::string reference_name(std::string_view text) {
    const std::string_view name = text.substr(0, text.find_first_of("@[."));
    const size_t group = name.find("::");
    return std::string(group == std::string_view::npos ? name : name.substr(group + 2));
}

}  // namespace weft
