/* SPDX-License-Identifier: Apache-2.0 */
#include "base/file.h"

#include "base/error.h"
#include "base/process.h"
#include "base/text.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Declared here because this library stays free of stdio (C11 7.1.4 allows it). */
int rename(const char *from, const char *to);

static bool fail(ndl_error *error, const char *what, int number) {
    char reason[128];
    if (strerror_r(number, reason, sizeof reason) != 0) strcpy(reason, "unknown error");
    return nd_fail(error, NDL_E_FILE, 0, what, reason, NULL);
}

static bool cannot_write(ndl_error *error, int number) {
    return fail(error, "cannot be written: ", number);
}

bool nd_file_readable(const char *path, ndl_error *error) {
    struct stat about;
    int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0) return fail(error, "cannot be opened: ", errno);
    int failed = fstat(file, &about) != 0;
    close(file);
    if (failed) return fail(error, "cannot be opened: ", errno);
    if (S_ISDIR(about.st_mode)) return fail(error, "cannot be read: ", EISDIR);
    if (!S_ISREG(about.st_mode))
        return nd_fail(error, NDL_E_FILE, 0, "is not a file but a device or a pipe", NULL);
    return true;
}

/* Writes and closes; 0 or the error's number. */
static int write_all(int file, const unsigned char *bytes, size_t n) {
    int number = 0;
    while (n && !number) {
        ssize_t written = write(file, bytes, n);
        if (written < 0) {
            if (errno != EINTR) number = errno;
            continue;
        }
        bytes += written;
        n -= (size_t)written;
    }
    if (close(file) != 0 && !number) number = errno;
    return number;
}

/* Creates a file beside `path` that was not there; its name goes into *name (free). */
static int create_beside(const char *path, char **name, int *number) {
    for (int attempt = 0; attempt < 1000; attempt++) {
        nd_text t = {0};
        nd_text_add(&t, path);
        nd_text_add(&t, ".part");
        nd_text_int(&t, (long long)getpid());
        if (attempt) {
            nd_text_add(&t, "-");
            nd_text_int(&t, attempt);
        }
        *name = nd_text_take(&t);
        *number = ENOMEM;
        if (!*name) return -1;
        int file = open(*name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0) return file;
        *number = errno;
        free(*name);
        *name = NULL;
        if (*number != EEXIST) return -1;
    }
    return -1;
}

bool nd_file_replace(const char *path, const void *bytes, size_t n, ndl_error *error) {
    struct stat about;
    if (stat(path, &about) == 0 && !S_ISREG(about.st_mode)) {
        int file = open(path, O_WRONLY | O_CLOEXEC);
        int number = file < 0 ? errno : write_all(file, bytes, n);
        return number ? cannot_write(error, number) : true;
    }
    char *name = NULL;
    int number = 0;
    int file = create_beside(path, &name, &number);
    if (file < 0) return cannot_write(error, number);
    number = write_all(file, bytes, n);
    bool cancelled = nd_interrupted();
    if (!number && !cancelled && rename(name, path) != 0) number = errno;
    if (number || cancelled) unlink(name);
    free(name);
    if (number) return cannot_write(error, number);
    if (cancelled) return nd_fail(error, NDL_E_CANCELLED, 0, "interrupted", NULL);
    return true;
}
