// The part of the sandbox that restricts system calls: a seccomp filter that allows the calls that rendering
// needs. Other calls fail, nearly always with EPERM. Examples are the calls for network sockets, mounts,
// kernel modules, and tracing other processes.
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include "viewer/sandbox/sandbox_parts.h"

namespace weft::viewer {
namespace {

#if defined(__x86_64__)
constexpr uint32_t kProcessor = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr uint32_t kProcessor = AUDIT_ARCH_AARCH64;
#else
constexpr uint32_t kProcessor = 0;
#endif

// Calls on files and file descriptors. Landlock restricts which files a process can open.
constexpr long kFileCalls[] = {SYS_read,
                               SYS_write,
                               SYS_readv,
                               SYS_writev,
                               SYS_pread64,
                               SYS_pwrite64,
                               SYS_preadv,
                               SYS_pwritev,
                               SYS_preadv2,
                               SYS_pwritev2,
                               SYS_lseek,
                               SYS_close,
                               SYS_close_range,
                               SYS_dup,
                               SYS_dup3,
                               SYS_flock,
                               SYS_fsync,
                               SYS_fdatasync,
                               SYS_sync_file_range,
                               SYS_ftruncate,
                               SYS_fallocate,
                               SYS_fadvise64,
                               SYS_fstat,
                               SYS_newfstatat,
                               SYS_statx,
                               SYS_statfs,
                               SYS_fstatfs,
                               SYS_faccessat,
                               SYS_faccessat2,
                               SYS_readlinkat,
                               SYS_getdents64,
                               SYS_getcwd,
                               SYS_chdir,
                               SYS_renameat,
                               SYS_renameat2,
                               SYS_unlinkat,
                               SYS_mkdirat,
                               SYS_umask,
                               SYS_pipe2,
                               SYS_sendfile,
                               SYS_copy_file_range,
                               SYS_memfd_create,
                               SYS_eventfd2,
                               SYS_timerfd_create,
                               SYS_timerfd_settime,
                               SYS_epoll_create1,
                               SYS_epoll_ctl,
                               SYS_epoll_pwait,
                               SYS_ppoll,
                               SYS_pselect6,
                               SYS_inotify_init1,
                               SYS_inotify_add_watch,
                               SYS_inotify_rm_watch};
// Calls that manage the memory of the process.
constexpr long kMemoryCalls[] = {SYS_mmap,    SYS_munmap, SYS_mprotect,   SYS_mremap,
                                 SYS_madvise, SYS_msync,  SYS_mincore,    SYS_mlock,
                                 SYS_munlock, SYS_brk,    SYS_membarrier, SYS_get_mempolicy};
// Calls for threads, signals and child processes.
constexpr long kThreadCalls[] = {SYS_futex,
                                 SYS_set_robust_list,
                                 SYS_get_robust_list,
                                 SYS_rseq,
                                 SYS_set_tid_address,
                                 SYS_execve,
                                 SYS_exit,
                                 SYS_exit_group,
                                 SYS_wait4,
                                 SYS_waitid,
                                 SYS_sched_yield,
                                 SYS_sched_getaffinity,
                                 SYS_sched_getparam,
                                 SYS_sched_getscheduler,
                                 SYS_getpriority,
                                 SYS_getcpu,
                                 SYS_prctl,
                                 SYS_getrlimit,
                                 SYS_setrlimit,
                                 SYS_getrusage,
                                 SYS_rt_sigaction,
                                 SYS_rt_sigprocmask,
                                 SYS_rt_sigreturn,
                                 SYS_rt_sigtimedwait,
                                 SYS_rt_sigpending,
                                 SYS_rt_sigsuspend,
                                 SYS_sigaltstack,
                                 SYS_restart_syscall};
// Calls on connected sockets that socketpair() created. None of these calls can reach another socket.
constexpr long kSocketCalls[] = {SYS_recvfrom, SYS_shutdown, SYS_getsockopt, SYS_setsockopt};
// Calls for time, random numbers, and information about this process.
constexpr long kOtherCalls[] = {
    SYS_nanosleep, SYS_clock_nanosleep, SYS_clock_gettime, SYS_clock_getres, SYS_gettimeofday, SYS_times,
    SYS_uname,     SYS_sysinfo,         SYS_getrandom,     SYS_getpid,       SYS_getppid,      SYS_gettid,
    SYS_getuid,    SYS_geteuid,         SYS_getgid,        SYS_getegid,      SYS_getresuid,    SYS_getresgid,
    SYS_getgroups, SYS_getpgid,         SYS_getsid,        SYS_capget};
#if defined(__x86_64__)
// Calls that exist only on x86-64. Most of them are older forms of calls that the filter allows.
constexpr long kOldCalls[] = {SYS_stat,   SYS_lstat,      SYS_access, SYS_readlink, SYS_rename,
                              SYS_unlink, SYS_mkdir,      SYS_pipe,   SYS_dup2,     SYS_poll,
                              SYS_select, SYS_epoll_wait, SYS_time,   SYS_getpgrp,  SYS_arch_prctl,
                              SYS_vfork,  SYS_fork};
#else
constexpr std::array<long, 0> kOldCalls{};
#endif

constexpr uint32_t word_of(size_t argument) {
    return static_cast<uint32_t>(offsetof(seccomp_data, args) + 8 * argument);
}
constexpr uint32_t upper_word_of(size_t argument) {
    // The upper 32 bits come after the lower 32 bits, because both supported processors are little-endian.
    return word_of(argument) + 4;
}

class Filter {
 public:
    Filter() {
        load(offsetof(seccomp_data, arch));
        end_unless(BPF_JEQ, kProcessor, SECCOMP_RET_KILL_PROCESS);
        load(offsetof(seccomp_data, nr));
#if defined(__x86_64__)
        constexpr uint32_t kX32Calls = 0x40000000;
        end_if(BPF_JGE, kX32Calls, refused(EPERM));
#endif
    }

    void answer(long call, uint32_t verdict) {
        end_if(BPF_JEQ, static_cast<uint32_t>(call), verdict);
    }
    void allow(long call) {
        answer(call, SECCOMP_RET_ALLOW);
    }

    // Refuses `call` with EPERM if a test of 32 bits of an argument is true. `word` is the offset of these
    // bits in seccomp_data. BPF_JEQ tests whether they equal `value`. BPF_JSET tests whether they and `value`
    // have a common bit that is 1. refuse_unless() refuses the call if the test is false.
    void refuse_if(long call, uint32_t word, uint16_t test, uint32_t value) {
        std::vector<sock_filter> block{loaded(word), jump(test, value, 0, 1), end(refused(EPERM)),
                                       loaded(offsetof(seccomp_data, nr))};
        only_for(call, block);
    }
    void refuse_unless(long call, uint32_t word, uint16_t test, uint32_t value) {
        std::vector<sock_filter> block{loaded(word), jump(test, value, 1, 0), end(refused(EPERM)),
                                       loaded(offsetof(seccomp_data, nr))};
        only_for(call, block);
    }
    // Refuses `call` unless (argument bits & `mask`) == `value`. `word` is the offset of the argument bits.
    void refuse_unless_masked(long call, uint32_t word, uint32_t mask, uint32_t value) {
        std::vector<sock_filter> block{loaded(word), sock_filter{BPF_ALU | BPF_AND | BPF_K, 0, 0, mask},
                                       jump(BPF_JEQ, value, 1, 0), end(refused(EPERM)),
                                       loaded(offsetof(seccomp_data, nr))};
        only_for(call, block);
    }
    // Refuses open(..., O_RDONLY | O_TRUNC). Such a call truncates a file although it does not ask for write
    // access. `flags` is the index of the flags among the arguments of `call`.
    void refuse_truncating_reads(long call, size_t flags) {
        std::vector<sock_filter> block{
            loaded(word_of(flags)), sock_filter{BPF_ALU | BPF_AND | BPF_K, 0, 0, O_ACCMODE | O_TRUNC},
            jump(BPF_JEQ, O_RDONLY | O_TRUNC, 0, 1), end(refused(EPERM)), loaded(offsetof(seccomp_data, nr))};
        only_for(call, block);
    }

    // Appends the rule that refuses all other calls, and installs the filter. Returns 0 on success, or a
    // value of errno.
    int install() {
        code_.push_back(end(refused(EPERM)));
        const sock_fprog program{static_cast<unsigned short>(code_.size()), code_.data()};
        if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return errno;
        return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0 ? 0 : errno;
    }

    static uint32_t refused(int error) {
        return SECCOMP_RET_ERRNO | static_cast<uint32_t>(error);
    }

 private:
    static sock_filter loaded(uint32_t offset) {
        return {BPF_LD | BPF_W | BPF_ABS, 0, 0, offset};
    }
    static sock_filter end(uint32_t verdict) {
        return {BPF_RET | BPF_K, 0, 0, verdict};
    }
    static sock_filter jump(uint16_t test, uint32_t value, uint8_t if_true, uint8_t if_false) {
        return {static_cast<uint16_t>(BPF_JMP | test | BPF_K), if_true, if_false, value};
    }
    void load(uint32_t offset) {
        code_.push_back(loaded(offset));
    }
    void end_if(uint16_t test, uint32_t value, uint32_t verdict) {
        code_.push_back(jump(test, value, 0, 1));
        code_.push_back(end(verdict));
    }
    void end_unless(uint16_t test, uint32_t value, uint32_t verdict) {
        code_.push_back(jump(test, value, 1, 0));
        code_.push_back(end(verdict));
    }
    void only_for(long call, const std::vector<sock_filter>& block) {
        code_.push_back(jump(BPF_JEQ, static_cast<uint32_t>(call), 0, static_cast<uint8_t>(block.size())));
        code_.insert(code_.end(), block.begin(), block.end());
    }

    std::vector<sock_filter> code_;
};

// Adds the calls that are allowed only with some arguments.
void add_judged_calls(Filter& filter, int landlock_version) {
    // Threads and child processes are allowed, new namespaces are not. The flags of clone3 are in memory,
    // where the filter cannot read them, so the filter answers as if clone3 did not exist. glibc then uses
    // clone.
    filter.answer(SYS_clone3, Filter::refused(ENOSYS));
    filter.refuse_if(SYS_clone, word_of(0), BPF_JSET,
                     CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER |
                         CLONE_NEWPID | CLONE_NEWNET);
    filter.allow(SYS_clone);
    // socketpair() creates two sockets that are connected only to each other. Stream sockets are allowed.
    // Datagram sockets are refused, because they can also send to other sockets by name.
    filter.refuse_unless(SYS_socketpair, word_of(0), BPF_JEQ, AF_UNIX);
    filter.refuse_unless_masked(SYS_socketpair, word_of(1), 0xf, SOCK_STREAM);
    filter.allow(SYS_socketpair);
    // sendto() is allowed only without a destination address: the pointer, argument 4, must be null.
    filter.refuse_unless(SYS_sendto, word_of(4), BPF_JEQ, 0);
    filter.refuse_unless(SYS_sendto, upper_word_of(4), BPF_JEQ, 0);
    filter.allow(SYS_sendto);
    // Refuse to set the owner or the signal of a file descriptor. The owner is the process that gets signals
    // about the descriptor, so a process in the sandbox could send signals to any process of the user.
    for (const uint32_t owner : {F_SETOWN, F_SETOWN_EX, F_SETSIG})
        filter.refuse_if(SYS_fcntl, word_of(1), BPF_JEQ, owner);
    filter.allow(SYS_fcntl);
    for (const uint32_t owner : {FIOSETOWN, SIOCSPGRP})
        filter.refuse_if(SYS_ioctl, word_of(1), BPF_JEQ, owner);
    // Refuse calls that insert input into the user's terminal, as if the user had typed it.
    constexpr uint32_t kTypeLinux = 0x541C;  // The request TIOCLINUX, which can paste text into a console.
    filter.refuse_if(SYS_ioctl, word_of(1), BPF_JEQ, TIOCSTI);
    filter.refuse_if(SYS_ioctl, word_of(1), BPF_JEQ, kTypeLinux);
    filter.allow(SYS_ioctl);
    // Only the resource limits of this process may be changed (process id 0).
    filter.refuse_unless(SYS_prlimit64, word_of(0), BPF_JEQ, 0);
    filter.allow(SYS_prlimit64);
    // Landlock restricts signals from version 6 on. With older versions, the filter refuses kill(), and
    // allows tgkill() only with this process as the target.
    if (landlock_version < 6)
        filter.refuse_unless(SYS_tgkill, word_of(0), BPF_JEQ, static_cast<uint32_t>(getpid()));
    filter.allow(SYS_tgkill);
    if (landlock_version >= 6) filter.allow(SYS_kill);
    // Landlock restricts truncation from version 3 on.
    if (landlock_version < 3) filter.refuse_truncating_reads(SYS_openat, 2);
    filter.allow(SYS_openat);
    // The flags of openat2 are in memory, where the filter cannot read them. So the filter answers as if
    // openat2 did not exist.
    filter.answer(SYS_openat2, Filter::refused(ENOSYS));
#if defined(__x86_64__)
    if (landlock_version < 3) filter.refuse_truncating_reads(SYS_open, 1);
    filter.allow(SYS_open);
#endif
}

}  // namespace

Status restrict_calls(int landlock_version) {
    if (kProcessor == 0) return no_sandbox("Weft has no list of allowed system calls for this processor", {});
    Filter filter;
    for (const std::span<const long> calls :
         {std::span<const long>(kFileCalls), std::span<const long>(kMemoryCalls),
          std::span<const long>(kThreadCalls), std::span<const long>(kSocketCalls),
          std::span<const long>(kOtherCalls), std::span<const long>(kOldCalls)})
        for (const long call : calls) filter.allow(call);
    add_judged_calls(filter, landlock_version);
    if (const int error = filter.install(); error != 0)
        return no_sandbox(std::string("the kernel does not accept a seccomp filter: ") + std::strerror(error),
                          "use a kernel with CONFIG_SECCOMP_FILTER");
    return Unit{};
}

}  // namespace weft::viewer
