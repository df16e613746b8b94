// Purpose: writes the data of commands to files and stdout. If data cannot be written, the reason is printed
// on stderr and the exit code is 1.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "viewer/output/exit_code.h"

namespace weft::viewer {

// Call this before threads and files exist. A closed pipe, or a file over its size limit, then gives a
// reported error instead of a signal, and no file gets the descriptor number of a closed standard stream.
void prepare_output();

// Reports, before any work is done, which of the paths cannot be written, and which would replace another
// output or one of the files `inputs`. Empty paths are ignored.
[[nodiscard]] ExitCode check_outputs(const std::vector<std::string>& paths,
                                     const std::vector<std::string>& inputs);

// Writes to stdout. Returns `code`, unless writing fails.
[[nodiscard]] ExitCode print_data(std::string_view data, ExitCode code = ExitCode::ok);
// Writes to a file, or to stdout when `path` is empty.
[[nodiscard]] ExitCode output_data(const std::string& path, std::string_view data);

}  // namespace weft::viewer
