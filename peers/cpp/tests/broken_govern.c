/* The library, but for one function: its governor forgets every ESTOP at once. Everything else is the library
 * that this one is linked with. */
#define _GNU_SOURCE
#include <ncp.h>

#include <dlfcn.h>

typedef char *govern(ncp_governor *, const char *, double, const char *, const double *);

char *ncp_governor_govern(ncp_governor *governor, const char *command, double now_s,
                          const char *sensor, const double *last_sensor_s) {
    govern *whole;
    char *frame;

    *(void **)&whole = dlsym(RTLD_NEXT, "ncp_governor_govern");
    frame = whole(governor, command, now_s, sensor, last_sensor_s);
    ncp_governor_reset(governor);
    return frame;
}
