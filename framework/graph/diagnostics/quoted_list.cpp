#include "graph/diagnostics/quoted_list.h"

namespace weft {
namespace {

// A list in a message shows at most this many names, because a longer list would not help the reader of the
// message.
constexpr size_t kMostListed = 64;

}  // namespace

std::string quoted_list(const std::vector<std::string>& names) {
    const size_t shown = names.size() > kMostListed ? kMostListed : names.size();
    std::string text;
    for (size_t i = 0; i < shown; ++i) {
        if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
        text += "\"" + names[i] + "\"";
    }
    if (shown < names.size()) text += " and " + std::to_string(names.size() - shown) + " more";
    return text;
}

}  // namespace weft
