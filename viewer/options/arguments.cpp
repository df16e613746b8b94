#include "viewer/options/arguments.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <system_error>

#include "viewer/options/numbers.h"
#include "weft/result.h"

namespace weft::viewer {
namespace {

struct FutureFlag {
    const char* name;
    const char* what;
};
constexpr std::array kFutureRenderFlags{
    FutureFlag{"--profile", "rendering for a device profile"},
};

struct FutureFlags {
    const char* command;
    std::span<const FutureFlag> flags;
};
constexpr std::array kFutureViewFlags{
    FutureFlag{"--sandbox", "writing pictures while a sandbox runs"},
};
constexpr std::array kFutureFlags{FutureFlags{"render", kFutureRenderFlags},
                                  FutureFlags{"view", kFutureViewFlags}};

// Range of values of --param. Shaders get parameters as 32-bit floats.
constexpr NumberRange kParam{-3.4e38, 3.4e38, ""};
constexpr uint64_t kMostSide_px = 16'384;
constexpr uint64_t kMostFrames = 1'000'000;

bool is_truth(const std::string& text) {
    return text == "true" || text == "false";
}

// Returns ": did you mean ...?" with the most similar known word, or an empty text if no word is similar.
std::string with_guess(const std::string& text, const std::vector<std::string>& known) {
    const std::string guess = did_you_mean_text(text, known);
    return guess.empty() ? "" : ": " + guess;
}

}  // namespace

std::string size_fault(const std::string& text) {
    const size_t by = text.find('x');
    const auto is_side = [](const std::string& side) {
        return whole_number_fault(side, 1, kMostSide_px).empty();
    };
    if (by != std::string::npos && is_side(text.substr(0, by)) && is_side(text.substr(by + 1))) return "";
    return "\"" + text + "\" is not a size; wanted WIDTHxHEIGHT in pixels, each 1 to 16384";
}

Extent3D parse_size(const std::string& text) {
    const size_t by = std::min(text.find('x'), text.size() - 1);
    Extent3D size;
    size.width = static_cast<uint32_t>(whole_number(text.substr(0, by)).value_or(1));
    size.height = static_cast<uint32_t>(whole_number(text.substr(by + 1)).value_or(1));
    return size;
}

std::string frames_fault(const std::string& text) {
    const size_t dots = text.find("..");
    if (dots == std::string::npos) return whole_number_fault(text, 1, kMostFrames);
    for (const std::string& end : {text.substr(0, dots), text.substr(dots + 2)})
        if (const std::string fault = whole_number_fault(end, 1, kMostFrames); !fault.empty()) return fault;
    const FrameRange range = parse_frames(text);
    if (range.first_picture <= range.frames) return "";
    return "the range of frames \"" + text + "\" is empty; wanted A..B, where B is at least A";
}

FrameRange parse_frames(const std::string& text) {
    const size_t dots = text.find("..");
    const auto number = [](const std::string& end) {
        return static_cast<uint32_t>(whole_number(end).value_or(0));
    };
    if (dots == std::string::npos) return {0, number(text)};
    return {number(text.substr(0, dots)), number(text.substr(dots + 2))};
}

std::string param_fault(const std::string& text) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        return "\"" + text + "\" is not a parameter; wanted NAME=VALUE";
    const std::string value = text.substr(equals + 1);
    if (is_truth(value)) return "";
    if (!finite_number(value))
        return "\"" + value + "\" is not a value of a parameter; wanted a number, true or false";
    return number_fault(value, kParam);
}

std::string choice_fault(const std::string& text, const std::vector<std::string>& choices) {
    if (std::ranges::find(choices, text) != choices.end()) return "";
    std::string all;
    for (const std::string& choice : choices) all += (all.empty() ? "" : ", ") + choice;
    return "\"" + text + "\" is not one of " + all + with_guess(text, choices);
}

std::string plot_fault(const std::string& text) {
    return text.size() > 4 && text.ends_with(".svg")
               ? ""
               : "\"" + text + "\" is not a name of a plot; wanted FILE.svg";
}

std::string folder_fault(const std::string& text) {
    std::error_code failed;
    return std::filesystem::is_directory(text, failed) ? "" : "\"" + text + "\" is not a folder";
}

std::string env_fault(const std::string& text) {
    const bool is_file = text.find_first_of("./") != std::string::npos;
    return text == "sky" || text == "none" || is_file
               ? ""
               : "\"" + text + "\" is not an environment; wanted sky, none or a Radiance picture (FILE.hdr)" +
                     with_guess(text, {"sky", "none"});
}

std::map<std::string, double> parse_params(const std::vector<std::string>& texts) {
    std::map<std::string, double> params;
    for (const std::string& text : texts) {
        const size_t equals = text.find('=');
        const std::string value = text.substr(equals + 1);
        params[text.substr(0, equals)] =
            is_truth(value) ? (value == "true" ? 1 : 0) : finite_number(value).value_or(0);
    }
    return params;
}

namespace {

// Returns the texts between the commas after the equals sign; none if nothing follows the equals sign.
std::vector<std::string> list_items(const std::string& text) {
    std::vector<std::string> items;
    for (size_t at = text.find('='); at != std::string::npos && at + 1 < text.size();) {
        const size_t comma = text.find(',', at + 1);
        items.push_back(text.substr(at + 1, comma == std::string::npos ? comma : comma - at - 1));
        at = comma;
    }
    return items;
}

}  // namespace

std::string turns_fault(const std::string& text) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        return "\"" + text + "\" is not a list of turns; wanted NAME=ROUND,ROUND…";
    const std::vector<std::string> items = list_items(text);
    for (const std::string& item : items)
        if (!whole_number_fault(item, 0, UINT32_MAX).empty())
            return "\"" + item +
                   "\" is not a number of a round; wanted whole numbers with commas between them";
    return text.ends_with(',') ? "the list of turns \"" + text + "\" ends with a comma; remove it" : "";
}

std::map<std::string, std::vector<uint32_t>, std::less<>> parse_turns(const std::vector<std::string>& texts) {
    std::map<std::string, std::vector<uint32_t>, std::less<>> turns;
    for (const std::string& text : texts) {
        std::vector<uint32_t>& rounds = turns[text.substr(0, text.find('='))];
        rounds.clear();
        for (const std::string& item : list_items(text))
            rounds.push_back(static_cast<uint32_t>(whole_number(item).value_or(0)));
    }
    return turns;
}

std::string future_fault(const std::vector<std::string>& arguments) {
    if (arguments.empty()) return "";
    const auto says = [&](const char* word) { return std::ranges::find(arguments, word) != arguments.end(); };
    if (arguments[0] == "view" && !says("--headless") && !says("--help") && !says("-h"))
        return "this version of weft has no window yet; use `weft view --headless`";
    for (const FutureFlags& command : kFutureFlags) {
        if (arguments.front() != command.command) continue;
        for (const std::string& argument : arguments)
            for (const FutureFlag& flag : command.flags)
                if (argument.substr(0, argument.find('=')) == flag.name)
                    return std::string(flag.name) + ": " + flag.what +
                           " is not available in this version of weft";
    }
    return "";
}

}  // namespace weft::viewer
