// Purpose: names of parts of groups and modules, such as "relight::raw", and the name at the beginning of a
// reference, which is needed to expand shorthand notation before the references are parsed.
#pragma once

#include <string>
#include <string_view>

namespace weft {

// Stands between the name of a group or module and the name of its part, as in "relight::raw".
inline constexpr std::string_view kInGroup = "::";

// Returns the full name of a part of a group or module: "relight::raw" for "relight" and "raw". Without an
// owner, the name does not change.
[[nodiscard]] inline std::string name_in_group(std::string_view owner, std::string_view name) {
    return owner.empty() ? std::string(name) : std::string(owner).append(kInGroup).append(name);
}

// Returns the name of the resource in a reference, for example "hiz" for "hiz@build.mip(0)". The names of
// groups and modules are left out: "raw" for "relight::raw".
[[nodiscard]] inline std::string reference_name(std::string_view text) {
    const std::string_view name = text.substr(0, text.find_first_of("@[."));
    const size_t owner = name.rfind(kInGroup);
    return std::string(owner == std::string_view::npos ? name : name.substr(owner + kInGroup.size()));
}

}  // namespace weft
