// Purpose: notations of the command line (sizes, parameters), and names that are reserved for later versions.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "weft/declaration.h"

namespace weft::viewer {

// The fault in a size such as "1280x720"; empty if it is valid.
[[nodiscard]] std::string size_fault(const std::string& text);
[[nodiscard]] Extent3D parse_size(const std::string& text);

// The fault in a value of --env, as far as it can be found without opening a file; empty if there is none.
[[nodiscard]] std::string env_fault(const std::string& text);

// The fault in NAME=VALUE, where VALUE must be a number, true or false; empty if it is valid.
[[nodiscard]] std::string param_fault(const std::string& text);
[[nodiscard]] std::map<std::string, double> parse_params(const std::vector<std::string>& texts);

// The fault in a word that is not one of the choices; empty if it is one.
[[nodiscard]] std::string choice_fault(const std::string& text, const std::vector<std::string>& choices);

// The fault in the file name of a plot; empty if it is valid.
[[nodiscard]] std::string plot_fault(const std::string& text);

// A message for a flag or command that is reserved for a later version; empty if the arguments contain none.
// It is reported before any other fault, and its values are not checked.
[[nodiscard]] std::string future_fault(const std::vector<std::string>& arguments);

}  // namespace weft::viewer
