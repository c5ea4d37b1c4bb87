/* SPDX-License-Identifier: Apache-2.0 */
/* The processor and its caches, as Linux tells them; elsewhere common sizes. */
#include "base/threads.h"
#include "bench.h"

#include <stdio.h>
#include <string.h>

const char *const bench_level_names[BENCH_LEVELS] = {"L1", "L2", "DRAM"};

/* The first line of a small file, without its end; "" where there is none. */
static void read_line(const char *path, char *line, int room) {
    FILE *f = fopen(path, "r");
    line[0] = '\0';
    if (!f) return;
    if (!fgets(line, room, f)) line[0] = '\0';
    line[strcspn(line, "\n")] = '\0';
    fclose(f);
}

static void read_caches(bench_machine *m) {
    for (int index = 0; index < 8; index++) {
        char path[96], text[3][32];
        static const char *const files[] = {"level", "type", "size"};
        for (int i = 0; i < 3; i++) {
            snprintf(path, sizeof path, "/sys/devices/system/cpu/cpu0/cache/index%d/%s", index,
                     files[i]);
            read_line(path, text[i], sizeof text[i]);
        }
        unsigned long kib = 0;
        int level = text[0][0] - '0';
        if (level < 1 || level > 3 || strcmp(text[1], "Instruction") == 0) continue;
        if (sscanf(text[2], "%luK", &kib) == 1 && kib) m->cache[level] = (size_t)kib * 1024;
    }
}

static void read_name(bench_machine *m) {
    FILE *f = fopen("/proc/cpuinfo", "r");
    char line[256];
    while (f && fgets(line, sizeof line, f)) {
        const char *value = strchr(line, ':');
        if (strncmp(line, "model name", 10) != 0 || !value) continue;
        snprintf(m->cpu, sizeof m->cpu, "%.*s", (int)strcspn(value + 2, "\n"), value + 2);
        break;
    }
    if (f) fclose(f);
}

void bench_machine_read(bench_machine *m) {
    *m = (bench_machine){
        .cpu = "unknown", .processors = nd_processors(), .cache = {0, 32 << 10, 1 << 20, 32 << 20}};
    read_caches(m);
    read_name(m);
}

bench_level bench_level_of(const bench_machine *m, size_t n, size_t bytes) {
    if (n <= m->cache[1] / bytes) return BENCH_L1;
    return n <= m->cache[2] / bytes ? BENCH_L2 : BENCH_DRAM;
}

size_t bench_level_pairs(const bench_machine *m, bench_level level, size_t bytes) {
    enum { TILE = 256, LEAST_DRAM = 1 << 21, MOST_DRAM = 1 << 24 };
    size_t room = level == BENCH_DRAM ? 4 * m->cache[3] : m->cache[1 + level] / 2;
    size_t n = room / bytes / TILE * TILE;
    if (level != BENCH_DRAM) return n ? n : TILE;
    return n < LEAST_DRAM ? LEAST_DRAM : n > MOST_DRAM ? MOST_DRAM : n;
}
