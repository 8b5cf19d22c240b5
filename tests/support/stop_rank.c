/* A library that, preloaded, stops its process (SIGSTOP) where it is rank OVERTURN_STOP_RANK and makes the call
   OVERTURN_STOP_CALL (open, read or unlink) on a file whose path ends with OVERTURN_STOP_AT, for the first time. The
   file OVERTURN_STOP_SAYS then holds its number. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

static int is(char const* name, char const* value) {
    char const* const wished = getenv(name);
    return wished != NULL && value != NULL && strcmp(wished, value) == 0;
}

static void stop_at(char const* call, char const* path) {
    static int stopped;
    char const* const end = getenv("OVERTURN_STOP_AT");
    size_t const length = end == NULL ? 0 : strlen(end);
    if (stopped || length == 0 || strlen(path) < length || strcmp(path + strlen(path) - length, end) != 0
        || !is("OVERTURN_STOP_CALL", call) || !is("OVERTURN_STOP_RANK", getenv("OMPI_COMM_WORLD_RANK"))) {
        return;
    }
    stopped = 1;
    int const before = errno;
    FILE* (*const next)(char const*, char const*) = (FILE * (*)(char const*, char const*)) dlsym(RTLD_NEXT, "fopen");
    FILE* const file = next(getenv("OVERTURN_STOP_SAYS"), "w");
    if (file != NULL) {
        fprintf(file, "%d", (int)getpid());
        fclose(file);
    }
    raise(SIGSTOP);
    errno = before;
}

static int opened(char const* name, char const* path, int flags, int mode) {
    int (*const next)(char const*, int, ...) = (int (*)(char const*, int, ...))dlsym(RTLD_NEXT, name);
    stop_at("open", path);
    return next(path, flags, mode);
}

int open(char const* path, int flags, ...) {
    va_list more;
    va_start(more, flags);
    int const mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(more, int) : 0;
    va_end(more);
    return opened("open", path, flags, mode);
}

int open64(char const* path, int flags, ...) {
    va_list more;
    va_start(more, flags);
    int const mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(more, int) : 0;
    va_end(more);
    return opened("open64", path, flags, mode);
}

/* As the standard library opens what a stream reads. */
FILE* fopen(char const* path, char const* mode) {
    FILE* (*const next)(char const*, char const*) = (FILE * (*)(char const*, char const*)) dlsym(RTLD_NEXT, "fopen");
    stop_at("read", path);
    return next(path, mode);
}

FILE* fopen64(char const* path, char const* mode) {
    FILE* (*const next)(char const*, char const*) = (FILE * (*)(char const*, char const*)) dlsym(RTLD_NEXT, "fopen64");
    stop_at("read", path);
    return next(path, mode);
}

int unlink(char const* path) {
    int (*const next)(char const*) = (int (*)(char const*))dlsym(RTLD_NEXT, "unlink");
    stop_at("unlink", path);
    return next(path);
}

int remove(char const* path) {
    int (*const next)(char const*) = (int (*)(char const*))dlsym(RTLD_NEXT, "remove");
    stop_at("unlink", path);
    return next(path);
}
