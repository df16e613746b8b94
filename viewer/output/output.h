// Purpose: where the data of a command goes: files and stdout. Whatever keeps data from arriving is printed
// to stderr and ends in exit code 1.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "viewer/output/exit_code.h"

namespace weft::viewer {

// Before there are threads or files. A closed pipe and a file that grows over its limit become errors that
// are reported, and no file can get the number of a standard stream that was closed.
void prepare_output();

// Says before any work is done which of the paths cannot be written, and which would replace another of them
// or one of the files `inputs`. Empty paths are passed over.
[[nodiscard]] ExitCode check_outputs(const std::vector<std::string>& paths,
                                     const std::vector<std::string>& inputs);

// To stdout. `code` unless that fails.
[[nodiscard]] ExitCode print_data(std::string_view data, ExitCode code = ExitCode::ok);
// To a file, or to stdout when `path` is empty.
[[nodiscard]] ExitCode output_data(const std::string& path, std::string_view data);

}  // namespace weft::viewer
