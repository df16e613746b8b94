#include "viewer/output/progress_text.h"

namespace weft::viewer {
namespace {

constexpr double kQuietS = 1;
constexpr double kRenewS = 0.1;
constexpr const char* kWipe = "\r\x1b[K";

}  // namespace

std::string ProgressText::at(double elapsed_s, const std::string& what, uint64_t done, uint64_t total) {
    if (what != what_) {
        what_ = what;
        tenth_ = 0;
    }
    if (total == 0 || elapsed_s < kQuietS) return "";
    const std::string line =
        "weft: " + task_ + ": " + what + ", " + std::to_string(done) + " of " + std::to_string(total);
    if (terminal_) {
        if (last_line_s_ >= 0 && elapsed_s - last_line_s_ < kRenewS && done < total) return "";
        last_line_s_ = elapsed_s;
        return kWipe + line;
    }
    const uint64_t tenth = done * 10 / total;
    if (tenth <= tenth_) return "";
    tenth_ = tenth;
    return line + "\n";
}

std::string ProgressText::finish() {
    const bool there = last_line_s_ >= 0;
    last_line_s_ = -1;
    return there ? kWipe : "";
}

}  // namespace weft::viewer
