#include "output.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>

#include "file/write_file.h"

namespace weft::viewer {
namespace {

ExitCode outcome(const Status& status, ExitCode code = ExitCode::ok) {
    if (status) return code;
    report(status.errors());
    return exit_code_for(status.errors());
}

}  // namespace

void prepare_output() {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    // Descriptors are given out from the lowest free number: this fills the gaps up to 2. Standard output and
    // standard error cannot be written through it, which is an error as it would be if they were closed.
    int descriptor = 0;
    while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = open("/dev/null", O_RDONLY);
    if (descriptor > STDERR_FILENO) close(descriptor);
}

ExitCode check_outputs(std::initializer_list<std::string> paths) {
    ExitCode code = ExitCode::ok;
    for (const std::string& path : paths)
        if (!path.empty()) code = outcome(check_writable(path), code);
    return code;
}

ExitCode print_data(std::string_view data, ExitCode code) {
    return outcome(write_stdout(data), code);
}

ExitCode output_data(const std::string& path, std::string_view data) {
    return path.empty() ? print_data(data) : outcome(write_file(path, data));
}

}  // namespace weft::viewer
