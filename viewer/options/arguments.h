// Purpose: parses texts of the command line (sizes, parameters), and rejects flags that are reserved for
// later versions.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "weft/declaration.h"

namespace weft::viewer {

// Returns a message if `text` is not a valid size such as "1280x720". Returns an empty text if the size is
// valid.
[[nodiscard]] std::string size_fault(const std::string& text);
[[nodiscard]] Extent3D parse_size(const std::string& text);

// Returns a message if `text` is not a valid value of --env. Only the text is checked, because no file is
// opened here. Returns an empty text if the value is valid.
[[nodiscard]] std::string env_fault(const std::string& text);

// The frames of --frames. The first frame has the number 1.
struct FrameRange {
    uint32_t first_picture = 0;  // The first frame that is written; 0: only the last frame is written.
    uint32_t frames = 0;         // The last frame.
};

// Returns a message if `text` is neither a number N nor a range A..B of frames. Returns an empty text if it
// is valid.
[[nodiscard]] std::string frames_fault(const std::string& text);
[[nodiscard]] FrameRange parse_frames(const std::string& text);

// Returns a message if `text` is not NAME=VALUE, where VALUE must be a number, true or false. Returns an
// empty text if the parameter is valid.
[[nodiscard]] std::string param_fault(const std::string& text);
[[nodiscard]] std::map<std::string, double> parse_params(const std::vector<std::string>& texts);

// Returns a message if `text` is not NAME=LIST. LIST is empty, or consists of whole numbers with commas
// between them. Returns an empty text if `text` is valid.
[[nodiscard]] std::string turns_fault(const std::string& text);
[[nodiscard]] std::map<std::string, std::vector<uint32_t>, std::less<>> parse_turns(
    const std::vector<std::string>& texts);

// Returns a message if `text` is none of the choices. Returns an empty text if it is one of them.
[[nodiscard]] std::string choice_fault(const std::string& text, const std::vector<std::string>& choices);

// Returns a message if the file name of a plot does not end with .svg. Returns an empty text if the name is
// valid.
[[nodiscard]] std::string plot_fault(const std::string& text);
[[nodiscard]] std::string folder_fault(const std::string& text);

// Returns a message if the arguments (without the name of the program) contain a flag that is reserved for a
// later version, or if the command is `view` and neither --headless nor --help is given. Otherwise, returns
// an empty text. Call this before CLI11 parses the arguments: the error of CLI11 for such a flag would be
// confusing.
[[nodiscard]] std::string future_fault(const std::vector<std::string>& arguments);

}  // namespace weft::viewer
