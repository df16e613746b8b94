// Purpose: writes the data of commands to files and stdout. If writing fails, the reason is printed to stderr
// and the exit code is 1.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "viewer/output/exit_code.h"

namespace weft::viewer {

// Prepares the process for output. Afterwards, writing to a closed pipe, or beyond the size limit for files,
// returns an error instead of raising a signal. Files that are opened later do not get the descriptor number
// of a closed standard stream. The program must call this function before it creates threads or opens files.
void prepare_output();

// Checks the output paths before any work is done. Reports paths that cannot be written, and paths that would
// overwrite another output or one of the input files. Empty paths are ignored.
[[nodiscard]] ExitCode check_outputs(const std::vector<std::string>& paths,
                                     const std::vector<std::string>& inputs);

// Writes the data to stdout. Returns `code`, or ExitCode::failed if writing fails.
[[nodiscard]] ExitCode print_data(std::string_view data, ExitCode code = ExitCode::ok);
// Writes the data to a file, or to stdout if `path` is empty.
[[nodiscard]] ExitCode output_data(const std::string& path, std::string_view data);

}  // namespace weft::viewer
