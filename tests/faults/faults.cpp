// SPDX-License-Identifier: MIT
// Preloaded into a program, makes one of its calls of the system fail, once.
//
//   FAULT_KIND   open, read, write, sync, rename or allocation
//   FAULT_AT     which call of that kind fails, from 1 on; 0: none does
//   FAULT_COUNT  a file that receives how many calls of each kind there were, a line each
//
// Calls are counted from main() on.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

enum Kind { kOpen, kRead, kWrite, kSync, kRename, kAllocation, kKinds };

constexpr std::array<const char*, kKinds> kNames{"open", "read",   "write",
                                                 "sync", "rename", "allocation"};
constexpr std::array<int, kKinds> kErrors{EMFILE, EIO, ENOSPC, EIO, EIO, ENOMEM};

std::array<std::atomic<long>, kKinds> calls{};
std::atomic<bool> counts{false};
int faulty = -1;
long fault_at = 0;

/// Whether this call is the one; sets errno then.
bool fails(Kind kind) noexcept {
  if (!counts.load(std::memory_order_relaxed)) return false;
  const long number = calls[kind].fetch_add(1) + 1;
  if (kind != faulty || number != fault_at) return false;
  errno = kErrors[kind];
  return true;
}

template <typename Function>
Function* next(const char* name) noexcept {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

void read_environment() {
  if (const char* at = std::getenv("FAULT_AT")) fault_at = std::atol(at);
  const char* name = std::getenv("FAULT_KIND");
  for (int kind = 0; name && kind < kKinds; ++kind)
    if (std::strcmp(name, kNames[static_cast<std::size_t>(kind)]) == 0) faulty = kind;
}

void write_counts() {
  const char* file = std::getenv("FAULT_COUNT");
  std::FILE* out = file ? std::fopen(file, "w") : nullptr;
  if (!out) return;
  for (std::size_t kind = 0; kind < kKinds; ++kind)
    std::fprintf(out, "%s %ld\n", kNames[kind], calls[kind].load());
  std::fclose(out);
}

using Main = int(int, char**, char**);
Main* wrapped_main = nullptr;

int counted_main(int argc, char** argv, char** environment) {
  read_environment();
  counts = true;
  const int status = wrapped_main(argc, argv, environment);
  counts = false;
  write_counts();
  return status;
}

mode_t mode_of(int flags, std::va_list& arguments) {
  const bool makes = (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
  return makes ? static_cast<mode_t>(va_arg(arguments, int)) : 0;
}

}  // namespace

#pragma GCC visibility push(default)  // these stand before those of the system
extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

int __libc_start_main(Main* main, int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*rtld_fini)(), void* stack_end) {
  wrapped_main = main;
  return next<int(Main*, int, char**, void (*)(), void (*)(), void (*)(), void*)>(
      "__libc_start_main")(counted_main, argc, argv, init, fini, rtld_fini, stack_end);
}

#define OPEN(name)                                                     \
  int name(const char* file, int flags, ...) {                         \
    std::va_list arguments;                                            \
    va_start(arguments, flags);                                        \
    const mode_t mode = mode_of(flags, arguments);                     \
    va_end(arguments);                                                 \
    if (fails(kOpen)) return -1;                                       \
    return next<int(const char*, int, ...)>(#name)(file, flags, mode); \
  }
OPEN(open)
OPEN(open64)

#define OPENAT(name)                                                                \
  int name(int folder, const char* file, int flags, ...) {                          \
    std::va_list arguments;                                                         \
    va_start(arguments, flags);                                                     \
    const mode_t mode = mode_of(flags, arguments);                                  \
    va_end(arguments);                                                              \
    if (fails(kOpen)) return -1;                                                    \
    return next<int(int, const char*, int, ...)>(#name)(folder, file, flags, mode); \
  }
OPENAT(openat)
OPENAT(openat64)

// A call `type name(parameters)` that returns `failed` where it fails.
#define CALL(kind, failed, type, name, parameters, arguments) \
  type name parameters {                                      \
    if (fails(kind)) return failed;                           \
    return next<type parameters>(#name) arguments;            \
  }
CALL(kOpen, nullptr, std::FILE*, fopen, (const char* file, const char* mode), (file, mode))
CALL(kOpen, nullptr, std::FILE*, fopen64, (const char* file, const char* mode), (file, mode))
CALL(kOpen, -1, int, mkstemp, (char* name), (name))
CALL(kOpen, -1, int, mkstemp64, (char* name), (name))
CALL(kOpen, -1, int, mkostemp, (char* name, int flags), (name, flags))
CALL(kOpen, -1, int, mkostemp64, (char* name, int flags), (name, flags))
CALL(kRead, -1, ssize_t, read, (int file, void* to, std::size_t size), (file, to, size))
CALL(kRead, -1, ssize_t, pread, (int file, void* to, std::size_t size, off_t at),
     (file, to, size, at))
CALL(kRead, -1, ssize_t, pread64, (int file, void* to, std::size_t size, off64_t at),
     (file, to, size, at))
CALL(kWrite, -1, ssize_t, write, (int file, const void* from, std::size_t size), (file, from, size))
CALL(kWrite, -1, ssize_t, pwrite, (int file, const void* from, std::size_t size, off_t at),
     (file, from, size, at))
CALL(kWrite, -1, ssize_t, pwrite64, (int file, const void* from, std::size_t size, off64_t at),
     (file, from, size, at))
CALL(kWrite, -1, int, ftruncate, (int file, off_t size), (file, size))
CALL(kSync, -1, int, fsync, (int file), (file))
CALL(kSync, -1, int, fdatasync, (int file), (file))
CALL(kRename, -1, int, rename, (const char* from, const char* to), (from, to))
CALL(kRename, -1, int, link, (const char* from, const char* to), (from, to))
CALL(kRename, -1, int, linkat, (int a, const char* from, int b, const char* to, int flags),
     (a, from, b, to, flags))

std::size_t fread(void* to, std::size_t size, std::size_t count, std::FILE* file) {
  if (fails(kRead)) {
    constexpr int kErrorSeen = 0x20;  // _IO_ERR_SEEN of glibc
    file->_flags |= kErrorSeen;
    return 0;
  }
  return next<std::size_t(void*, std::size_t, std::size_t, std::FILE*)>("fread")(to, size, count,
                                                                                 file);
}

void* malloc(std::size_t size) { return fails(kAllocation) ? nullptr : __libc_malloc(size); }
void* calloc(std::size_t count, std::size_t size) {
  return fails(kAllocation) ? nullptr : __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) {
  return fails(kAllocation) ? nullptr : __libc_realloc(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return fails(kAllocation) ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** to, std::size_t alignment, std::size_t size) {
  if (fails(kAllocation)) return ENOMEM;
  *to = __libc_memalign(alignment, size);
  return *to ? 0 : ENOMEM;
}

}  // extern "C"
#pragma GCC visibility pop
