// Purpose: the command line's own notations (sizes, parameters), and the part of its contract that this
// version cannot honour yet.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "weft/declaration.h"

namespace weft::viewer {

// What is wrong with "1280x720", or empty.
[[nodiscard]] std::string size_fault(const std::string& text);
[[nodiscard]] Extent3D parse_size(const std::string& text);

// What is wrong with what surrounds a scene, as far as one can tell without opening a file, or empty.
[[nodiscard]] std::string env_fault(const std::string& text);

// NAME=VALUE, where VALUE is a number, true or false. What is wrong with it, or empty.
[[nodiscard]] std::string param_fault(const std::string& text);
[[nodiscard]] std::map<std::string, double> parse_params(const std::vector<std::string>& texts);

// What is wrong with a word that is none of these, or empty.
[[nodiscard]] std::string choice_fault(const std::string& text, const std::vector<std::string>& choices);

// What is wrong with the name of a plot, or empty.
[[nodiscard]] std::string plot_fault(const std::string& text);

// A flag or command of the contract that is not there yet, as a message; empty when there is none. Such a
// thing is refused by name, whatever else is wrong; its values are of no interest.
[[nodiscard]] std::string future_fault(const std::vector<std::string>& arguments);

}  // namespace weft::viewer
