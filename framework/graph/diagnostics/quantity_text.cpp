#include "graph/diagnostics/quantity_text.h"

#include <array>
#include <cstdio>

#include <sstream>

namespace weft {

std::string bytes_text(uint64_t bytes) {
    std::array<char, 48> text{};
    if (bytes < 10240)
        std::snprintf(text.data(), text.size(), "%llu B", static_cast<unsigned long long>(bytes));
    else if (bytes < 10485760)
        std::snprintf(text.data(), text.size(), "%.1f KiB", static_cast<double>(bytes) / 1024.0);
    else
        std::snprintf(text.data(), text.size(), "%.1f MiB", static_cast<double>(bytes) / 1048576.0);
    return text.data();
}

std::string bytes_change_text(uint64_t from_bytes, uint64_t to_bytes) {
    return to_bytes < from_bytes ? "-" + bytes_text(from_bytes - to_bytes)
                                 : "+" + bytes_text(to_bytes - from_bytes);
}

std::string number_text(double value) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << value;
    return text.str();
}

std::string percent_text(uint64_t part, uint64_t whole) {
    std::array<char, 48> text{};
    const double percent = whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
    std::snprintf(text.data(), text.size(), "%.1f %%", percent);
    return text.data();
}

std::string count_text(size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string limit_bytes_text(uint64_t bytes) {
    constexpr std::array<const char*, 4> kUnits{" GiB", " MiB", " KiB", " B"};
    for (size_t i = 0; i + 1 < kUnits.size(); ++i) {
        const uint64_t unit = 1ull << (30 - 10 * i);
        if (bytes >= unit && bytes % unit == 0) return std::to_string(bytes / unit) + kUnits[i];
    }
    return bytes_text(bytes);
}

}  // namespace weft
