/* A library that, preloaded, lets a disk fail or be slow: writes to, or syncs of, files whose path holds
   OVERTURN_BAD_DISK_AT. OVERTURN_BAD_DISK_CALL is write, fsync or any; OVERTURN_BAD_DISK_ERRNO the error's number, or 0
   for one that takes 20 ms more; OVERTURN_BAD_DISK_AFTER how many such calls go well before, in each process. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

static char const* set(char const* name) {
    char const* const value = getenv(name);
    return value == NULL ? "" : value;
}

static int is_on_the_disk(int fd) {
    char link[64];
    char path[4096];
    snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
    ssize_t const length = readlink(link, path, sizeof path - 1);
    if (length < 0) {
        return 0;
    }
    path[length] = '\0';
    return strstr(path, set("OVERTURN_BAD_DISK_AT")) != NULL;
}

/* 1 where this call is to fail, with errno set. */
static int fails(char const* call, int fd) {
    static atomic_int calls;
    int const before = errno;
    char const* const wished = set("OVERTURN_BAD_DISK_CALL");
    if ((strcmp(wished, call) != 0 && strcmp(wished, "any") != 0) || !is_on_the_disk(fd)
        || atomic_fetch_add(&calls, 1) < atoi(set("OVERTURN_BAD_DISK_AFTER"))) {
        errno = before;
        return 0;
    }
    errno = atoi(set("OVERTURN_BAD_DISK_ERRNO"));
    if (errno == 0) {
        usleep(20000);
        return 0;
    }
    return 1;
}

ssize_t write(int fd, void const* bytes, size_t size) {
    ssize_t (*const next)(int, void const*, size_t) = (ssize_t(*)(int, void const*, size_t))dlsym(RTLD_NEXT, "write");
    return fails("write", fd) ? -1 : next(fd, bytes, size);
}

ssize_t pwrite(int fd, void const* bytes, size_t size, off_t at) {
    ssize_t (*const next)(int, void const*, size_t, off_t) =
        (ssize_t(*)(int, void const*, size_t, off_t))dlsym(RTLD_NEXT, "pwrite");
    return fails("write", fd) ? -1 : next(fd, bytes, size, at);
}

ssize_t pwrite64(int fd, void const* bytes, size_t size, off_t at) { return pwrite(fd, bytes, size, at); }

int fsync(int fd) {
    int (*const next)(int) = (int (*)(int))dlsym(RTLD_NEXT, "fsync");
    return fails("fsync", fd) ? -1 : next(fd);
}
