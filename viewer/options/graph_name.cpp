#include "viewer/options/graph_name.h"

#include <filesystem>

namespace weft::viewer {

GraphName read_graph_name(const std::string& text) {
    std::error_code error;
    const size_t colon = text.rfind(':');
    const bool has_tier = colon != std::string::npos && text.find('/', colon) == std::string::npos &&
                          !std::filesystem::exists(text, error);
    if (!has_tier) return {text, ""};
    return {text.substr(0, colon), text.substr(colon + 1)};
}

}  // namespace weft::viewer
