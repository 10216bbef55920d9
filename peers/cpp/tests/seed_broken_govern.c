/* The seed's govern with a defect: no limit reaches the governor. It comes before the archive's own, so that
 * the linker takes this one. */
#include <ncp.h>

char *ncp_govern(const char *limits, const char *command, double now_s, const char *sensor,
                 double last_sensor_s) {
    ncp_governor *governor = ncp_governor_new("{}");
    char *fields = ncp_validate("command_frame", command);
    char *frame = ncp_governor_govern(governor, fields, now_s, sensor,
                                      last_sensor_s < 0 ? NULL : &last_sensor_s);
    (void)limits;
    ncp_string_free(fields);
    ncp_governor_free(governor);
    return frame;
}
