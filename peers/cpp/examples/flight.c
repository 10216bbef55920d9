/* A plant and its commander in C: a command is governed, sent, received, and watched over. */
#include <ncp.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What the library could not do ends the program: a plant holds when nothing comes any more. */
static char *must(char *text) {
    if (text == NULL) {
        fprintf(stderr, "%s: %s\n", ncp_last_error_code(), ncp_last_error());
        exit(EXIT_FAILURE);
    }
    return text;
}

/* Sends what the governor lets pass of a flight at this speed from this place. */
static void fly(ncp_governor *governor, ncp_buffer *plant, int seq, double position,
                double speed) {
    char command[256], sensor[256];
    const double now_s = 0.1 * seq;
    char *governed, *frame, *channels;

    snprintf(command, sizeof command,
             "{\"seq\":%d,\"mode\":\"active\",\"ttl_ms\":200,\"channels\":"
             "{\"velocity_setpoint\":{\"data\":[%g,0,0],\"unit\":\"m/s\"}}}",
             seq, speed);
    snprintf(sensor, sizeof sensor,
             "{\"seq\":%d,\"channels\":{\"pose_position\":{\"data\":[%g,0,0],\"unit\":\"m\"}}}", seq,
             position);
    governed = must(ncp_governor_govern(governor, command, now_s, sensor, &now_s));
    frame = must(ncp_encode("command_frame", governed));

    /* On the other side of the network. */
    if (ncp_buffer_on_frame(plant, (const uint8_t *)frame, strlen(frame), now_s) != 1) {
        fprintf(stderr, "rejected: %s\n", ncp_last_error());
    }
    if (ncp_buffer_active(plant, now_s, &channels) == 1) {
        printf("x=%-4g asked %g m/s: %s\n", position, speed, channels);
        ncp_string_free(channels);
    } else {
        printf("x=%-4g asked %g m/s: %s\n", position, speed,
               ncp_buffer_is_stopped(plant) ? "stopped" : "holds");
    }
    ncp_string_free(frame);
    ncp_string_free(governed);
}

int main(void) {
    char *version = must(ncp_version());
    char *key = must(ncp_key_command(NULL, "uav3"));
    ncp_governor *governor = ncp_governor_new("{\"max_speed_mps\":1.5,\"geofence_radius_m\":5}");
    ncp_buffer *plant = ncp_buffer_new();

    if (governor == NULL || plant == NULL) {
        fprintf(stderr, "%s\n", ncp_last_error());
        return EXIT_FAILURE;
    }
    printf("NCP %s on %s\n", version, key);
    fly(governor, plant, 1, 0.0, 1.0); /* passes */
    fly(governor, plant, 2, 1.0, 9.0); /* is limited to 1.5 m/s */
    fly(governor, plant, 3, 4.9, 1.0); /* would leave the fence: holds */
    fly(governor, plant, 4, 5.1, 1.0); /* is outside: stops, for good */
    fly(governor, plant, 5, 0.0, 1.0);

    ncp_buffer_free(plant);
    ncp_governor_free(governor);
    ncp_string_free(key);
    ncp_string_free(version);
    return EXIT_SUCCESS;
}
