/* Every function of ncp.h: what it gives, and that NULL and a text that is not UTF-8 are errors where a text or
 * an object is required. A leak or an invalid read is for valgrind to find. */
#include <ncp.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* OWN_VERSION and OWN_HASH are defined on the command line. */
#define OWN_LENGTH (sizeof OWN_VERSION - 1)
#define BAD "\xff\xfe"
#define COMMAND "{\"mode\":\"active\",\"seq\":1,\"ttl_ms\":100,\"channels\":{\"velocity_setpoint\":{\"data\":[9,0,0],\"unit\":\"m/s\"}}}"
#define WIRE(fields) "{\"kind\":\"command_frame\",\"ncp_version\":\"" OWN_VERSION "\"," fields "}"
#define SENSOR "{\"kind\":\"sensor_frame\",\"seq\":1}"

static int failures = 0;

static void check(int holds, const char *what, int line) {
    if (!holds) {
        const char *why = ncp_last_error();
        printf("abi.c:%d: %s (last error: %s)\n", line, what, why ? why : "none");
        ++failures;
    }
}

#define CHECK(holds) check((holds), #holds, __LINE__)

/* A text that holds a part, and is freed. */
static int says(char *text, const char *part) {
    const int found = text != NULL && strstr(text, part) != NULL;
    if (text != NULL && !found) {
        printf("  it says %s\n", text);
    }
    ncp_string_free(text);
    return found;
}

static int is_code(const char *code) {
    return ncp_last_error_code() != NULL && strcmp(ncp_last_error_code(), code) == 0 &&
           strlen(ncp_last_error()) > 0;
}

#define SAYS(text, part) CHECK(says((text), (part)))
#define NO_TEXT(call, code) CHECK((call) == NULL && is_code(code))
#define NO_CODE(call, code) CHECK((call) == -1 && is_code(code))
#define BYTES(text) (const uint8_t *)(text), strlen(text)

static void seed(void) {
    CHECK(ncp_last_error() == NULL);
    SAYS(ncp_version(), OWN_VERSION);
    SAYS(ncp_default_realm(), "ncp");
    SAYS(ncp_contract_hash(), OWN_HASH);
    CHECK(ncp_check_version(OWN_VERSION, 1) == 1);
    CHECK(ncp_check_version("0.4", 0) == 0);
    NO_CODE(ncp_check_version("0.4", 1), "version");
    NO_CODE(ncp_check_version(NULL, 0), "missing");
    NO_CODE(ncp_check_version(BAD, 0), "malformed");
    CHECK(ncp_contract_status(OWN_HASH) == 1);
    CHECK(ncp_contract_status(NULL) == 0);
    CHECK(ncp_contract_status("2cf0763ad61e4f1c") == 2);
    NO_CODE(ncp_contract_status(BAD), "malformed");

    SAYS(ncp_key_rpc(NULL), "ncp/rpc");
    SAYS(ncp_key_sensor("lab", "uav3"), "lab/session/uav3/sensor");
    SAYS(ncp_key_command(NULL, "uav3"), "ncp/session/uav3/command");
    SAYS(ncp_key_observation(NULL, "uav3"), "ncp/session/uav3/observation");
    NO_TEXT(ncp_key_rpc(BAD), "malformed");
    NO_TEXT(ncp_key_sensor(NULL, NULL), "missing");
    NO_TEXT(ncp_key_command(NULL, BAD), "malformed");
    NO_TEXT(ncp_key_observation(NULL, "a/b"), "key");

    SAYS(ncp_encode_rates("\"uav\"", SENSOR), "\"err_x\":100.0");
    NO_TEXT(ncp_encode_rates(NULL, SENSOR), "missing");
    NO_TEXT(ncp_encode_rates("\"uav\"", NULL), "missing");
    NO_TEXT(ncp_encode_rates("\"uav\"", BAD), "malformed");
    SAYS(ncp_decode_command("\"uav\"", "{\"vel_x\":200}", 1.5, 7, NULL, NULL),
         "\"frame_id\":\"world\",\"mode\":\"active\"");
    SAYS(ncp_decode_command("\"uav\"", "{}", 1.5, 7, "map", "hold"),
         "\"frame_id\":\"map\",\"mode\":\"hold\"");
    NO_TEXT(ncp_decode_command("\"uav\"", "{}", 1.5, 7, NULL, BAD), "malformed");
    NO_TEXT(ncp_decode_command("\"uav\"", "{}", 1.5, 7, NULL, "go"), "value");
    NO_TEXT(ncp_decode_command("\"uav\"", "{}", 1.5, 7, BAD, NULL), "malformed");
    NO_TEXT(ncp_decode_command("\"uav\"", "{}", NAN, 7, NULL, NULL), "non_finite");

    SAYS(ncp_govern("{\"max_speed_mps\":1}", WIRE("\"mode\":\"active\",\"seq\":4"), 1.0, SENSOR, 1.0),
         "\"seq\":4");
    SAYS(ncp_govern("{}", WIRE("\"mode\":\"active\""), 1.0, SENSOR, -1.0), "\"mode\":\"hold\"");
    SAYS(ncp_govern("{}", WIRE("\"mode\":\"active\""), 1.0, SENSOR, NAN), "\"mode\":\"hold\"");
    SAYS(ncp_govern("{}", WIRE("\"mode\":\"active\""), 1.0, NULL, 1.0), "\"mode\":\"active\"");
    SAYS(ncp_govern("{}", WIRE("\"seq\":4"), 1.0, NULL, 1.0), "\"mode\":\"hold\"");
    NO_TEXT(ncp_govern(NULL, WIRE("\"mode\":\"active\""), 1.0, NULL, 1.0), "missing");
    NO_TEXT(ncp_govern("{\"max_sped_mps\":1}", WIRE("\"mode\":\"active\""), 1.0, NULL, 1.0), "invalid");
    NO_TEXT(ncp_govern("{}", NULL, 1.0, NULL, 1.0), "missing");
    NO_TEXT(ncp_govern("{}", WIRE("\"mode\":\"active\""), 1.0, BAD, 1.0), "malformed");

    SAYS(ncp_validate("command_frame", WIRE("\"mode\":\"dance\"")), "\"mode\":\"hold\"");
    NO_TEXT(ncp_validate("command_frame", SENSOR), "kind");
    NO_TEXT(ncp_validate("dance", SENSOR), "kind");
    NO_TEXT(ncp_validate(NULL, SENSOR), "missing");
    NO_TEXT(ncp_validate("sensor_frame", NULL), "missing");
    NO_TEXT(ncp_validate("sensor_frame", BAD), "malformed");
    ncp_string_free(NULL);
}

static void wire(void) {
    ncp_plane_qos_t qos;

    CHECK(ncp_extension_version() == 1);
    SAYS(ncp_library_version(), ".");
    CHECK(ncp_check_version_n(OWN_VERSION "+", OWN_LENGTH, 1) == 1);
    NO_CODE(ncp_check_version_n(OWN_VERSION "\0", OWN_LENGTH + 1, 0), "version");
    NO_CODE(ncp_check_version_n(NULL, 0, 0), "missing");
    CHECK(ncp_contract_status_n(NULL, 0) == 0);
    CHECK(ncp_contract_status_n(OWN_HASH "\0", 17) == 2);
    NO_CODE(ncp_contract_status_n(BAD, 2), "malformed");
    NO_CODE(ncp_contract_status_n(NULL, 3), "missing");
    CHECK(ncp_verify_contract(OWN_HASH, 16) == 1);
    NO_CODE(ncp_verify_contract(OWN_HASH, 15), "contract");
    NO_CODE(ncp_verify_contract(BAD, 2), "malformed");
    CHECK(ncp_negotiate(OWN_VERSION, OWN_LENGTH, NULL, 0) == 0);
    NO_CODE(ncp_negotiate("0.4", 3, NULL, 0), "version");
    NO_CODE(ncp_negotiate(NULL, 0, NULL, 0), "missing");

    SAYS(ncp_decode("sensor_frame", BYTES(SENSOR)), "\"seq\":1");
    NO_TEXT(ncp_decode("sensor_frame", (const uint8_t *)"{\0}", 3), "malformed");
    NO_TEXT(ncp_decode("sensor_frame", NULL, 0), "missing");
    NO_TEXT(ncp_decode(NULL, BYTES(SENSOR)), "missing");
    SAYS(ncp_encode("command_frame", "{}"), "\"mode\":\"active\"");
    NO_TEXT(ncp_encode("sensor_frame", "{\"t\":\"NaN\"}"), "non_finite");
    NO_TEXT(ncp_encode("sensor_frame", NULL), "missing");
    NO_TEXT(ncp_encode("sensor_frame", BAD), "malformed");
    SAYS(ncp_build("sensor_frame", "{\"t\":\"NaN\"}"), "\"t\":\"NaN\"");
    NO_TEXT(ncp_build("sensor_frame", NULL), "missing");
    CHECK(ncp_check_reply(BYTES("{\"kind\":\"close_session\",\"session_id\":\"s\"}"),
                          BYTES("{\"kind\":\"session_closed\",\"session_id\":\"s\",\"ok\":true}")) == 1);
    NO_CODE(ncp_check_reply(BYTES("{\"kind\":\"close_session\",\"session_id\":\"s\"}"),
                            BYTES("{\"kind\":\"error\",\"error\":\"no\"}")), "reply");
    NO_CODE(ncp_check_reply(NULL, 0, BYTES("{}")), "missing");

    SAYS(ncp_key("sensor", NULL, 0, "u", 1, "front", 5), "ncp/session/u/sensor/front");
    SAYS(ncp_key("fleet_glob", "lab", 3, NULL, 0, NULL, 0), "lab/session/**");
    NO_TEXT(ncp_key("sensor", NULL, 0, NULL, 0, NULL, 0), "missing");
    NO_TEXT(ncp_key("sensor", NULL, 0, "u\0", 2, NULL, 0), "key");
    NO_TEXT(ncp_key(NULL, NULL, 0, "u", 1, NULL, 0), "missing");
    NO_TEXT(ncp_key("door", NULL, 0, "u", 1, NULL, 0), "invalid");
    NO_TEXT(ncp_key("sensor", BAD, 2, "u", 1, NULL, 0), "malformed");
    CHECK(ncp_key_matches("a/**", 4, "a/b", 3) == 1);
    CHECK(ncp_key_matches("a/*", 3, "b/b", 3) == 0);
    NO_CODE(ncp_key_matches(NULL, 0, "b/b", 3), "missing");
    CHECK(ncp_plane_qos("action", &qos) == 1 && qos.express && strcmp(qos.priority, "RealTime") == 0 &&
          strcmp(qos.congestion, "drop") == 0);
    NO_CODE(ncp_plane_qos("actions", &qos), "invalid");
    NO_CODE(ncp_plane_qos(NULL, &qos), "missing");
    NO_CODE(ncp_plane_qos("action", NULL), "missing");
}

static void bulk(void) {
    const double times[] = {1.5, 2.5, 9.0};
    const int64_t senders[] = {7, 7, 9};
    ncp_column columns[2] = {{"times", 5, NCP_F64, 3, times}, {"senders", 7, NCP_I64, 3, senders}};
    ncp_column column;
    size_t len = 0, count = 0;
    uint8_t *packed, *encoded, *moved;
    ncp_block *block;
    ncp_arrays *arrays;

    packed = ncp_observation_pack(times, 3, NULL, 0, senders, 3, &len);
    CHECK(packed != NULL && len == 104);
    encoded = ncp_block_encode(columns, 2, &len);
    CHECK(encoded != NULL && len == 104 && memcmp(packed, encoded, 104) == 0);
    NO_TEXT(ncp_observation_pack(times, 3, NULL, 0, senders, 2, &len), "block");
    NO_TEXT(ncp_observation_pack(NULL, 3, NULL, 0, NULL, 0, &len), "missing");
    NO_TEXT(ncp_observation_pack(times, 3, NULL, 0, NULL, 0, NULL), "missing");
    NO_TEXT(ncp_block_encode(NULL, 1, &len), "missing");
    NO_TEXT(ncp_block_encode(columns, 2, NULL), "missing");
    columns[0].dtype = 5;
    NO_TEXT(ncp_block_encode(columns, 2, &len), "block");
    columns[0].dtype = NCP_F64;
    columns[0].name = NULL;
    NO_TEXT(ncp_block_encode(columns, 2, &len), "missing");
    columns[0].name = BAD;
    columns[0].name_len = 2;
    NO_TEXT(ncp_block_encode(columns, 2, &len), "malformed");

    /* At an odd address, and in a buffer without a byte to spare, so that valgrind sees any that is read
     * beyond it. */
    moved = malloc(105);
    memcpy(moved + 1, packed, 104);
    block = ncp_block_parse(moved + 1, 104);
    CHECK(block != NULL && ncp_block_columns(block) == 2);
    CHECK(ncp_block_column(block, 1, &column) == 1 && column.name_len == 7 && column.rows == 3 &&
          column.dtype == NCP_I64 && memcmp(column.data, senders, sizeof senders) == 0);
    NO_CODE(ncp_block_column(block, 2, &column), "invalid");
    NO_CODE(ncp_block_column(NULL, 0, &column), "missing");
    NO_CODE(ncp_block_column(block, 0, NULL), "missing");
    CHECK(ncp_block_columns(NULL) == 0);
    ncp_block_free(block);
    NO_TEXT(ncp_block_parse(moved + 1, 103), "block");
    NO_TEXT(ncp_block_parse(NULL, 0), "missing");

    arrays = ncp_observation_unpack(moved + 1, 104);
    CHECK(arrays != NULL);
    CHECK(memcmp(ncp_arrays_times(arrays, &count), times, sizeof times) == 0 && count == 3);
    CHECK(memcmp(ncp_arrays_senders(arrays, &count), senders, sizeof senders) == 0 && count == 3);
    CHECK(ncp_arrays_values(arrays, &count) != NULL && count == 0);
    NO_TEXT(ncp_arrays_times(NULL, &count), "missing");
    NO_TEXT(ncp_arrays_values(arrays, NULL), "missing");
    NO_TEXT(ncp_arrays_senders(NULL, &count), "missing");
    NO_TEXT(ncp_observation_unpack(moved + 1, 20), "block");
    ncp_arrays_free(arrays);
    free(moved);
    ncp_bytes_free(packed, 104);
    ncp_bytes_free(encoded, 104);
    ncp_bytes_free(NULL, 0);
    ncp_block_free(NULL);
    ncp_arrays_free(NULL);
}

static void safety(void) {
    const double now = 1.0, loss = 0.1;
    char *channels = (char *)"left over";
    ncp_link_report_t report;
    ncp_governor *governor = ncp_governor_new("{\"max_speed_mps\":1.5}");
    ncp_governor *negotiated = ncp_governor_from_capabilities("{\"safety\":{\"max_speed_mps\":1}}");
    ncp_watchdog *watchdog = ncp_watchdog_new();
    ncp_buffer *buffer = ncp_buffer_new();
    ncp_link *monitor = ncp_link_new(NULL, &loss);

    NO_TEXT(ncp_governor_new(NULL), "missing");
    NO_TEXT(ncp_governor_new(BAD), "malformed");
    NO_TEXT(ncp_governor_from_capabilities(NULL), "missing");
    SAYS(ncp_governor_govern(governor, COMMAND, 1.0, NULL, &now), "\"mode\":\"active\"");
    SAYS(ncp_governor_govern(governor, COMMAND, 1.0, NULL, NULL), "\"mode\":\"hold\"");
    NO_TEXT(ncp_governor_govern(governor, "{\"seq\":1}", 1.0, NULL, &now), "missing");
    NO_TEXT(ncp_governor_govern(governor, NULL, 1.0, NULL, &now), "missing");
    NO_TEXT(ncp_governor_govern(governor, COMMAND, 1.0, BAD, &now), "malformed");
    NO_TEXT(ncp_governor_govern(NULL, COMMAND, 1.0, NULL, &now), "missing");
    CHECK(ncp_governor_is_stopped(governor) == 0);
    CHECK(ncp_governor_note_link(governor, 1) == 1 && ncp_governor_is_stopped(governor) == 1);
    SAYS(ncp_governor_govern(governor, COMMAND, 1.0, NULL, &now), "\"mode\":\"estop\"");
    CHECK(ncp_governor_reset(governor) == 1 && ncp_governor_is_stopped(governor) == 0);
    CHECK(ncp_governor_has_config_fault(governor) == 0);
    CHECK(ncp_governor_has_config_fault(negotiated) == 1);
    NO_CODE(ncp_governor_note_link(NULL, 1), "missing");
    NO_CODE(ncp_governor_reset(NULL), "missing");
    NO_CODE(ncp_governor_is_stopped(NULL), "missing");
    NO_CODE(ncp_governor_has_config_fault(NULL), "missing");

    CHECK(ncp_watchdog_should_hold(watchdog, 1.0) == 1);
    CHECK(ncp_watchdog_on_command(watchdog, 1.0, 100.0, 1) == 1);
    CHECK(ncp_watchdog_on_command(watchdog, 1.0, 100.0, 1) == 0);
    CHECK(ncp_watchdog_should_hold(watchdog, 1.05) == 0);
    CHECK(ncp_watchdog_reset(watchdog) == 1 && ncp_watchdog_should_hold(watchdog, 1.05) == 1);
    NO_CODE(ncp_watchdog_on_command(NULL, 1.0, 100.0, 1), "missing");
    NO_CODE(ncp_watchdog_should_hold(NULL, 1.0), "missing");
    NO_CODE(ncp_watchdog_reset(NULL), "missing");

    CHECK(ncp_buffer_on_frame(buffer, BYTES(WIRE("\"mode\":\"active\",\"seq\":1,\"channels\":{\"c\":{\"data\":[1]}}")), 1.0) == 1);
    CHECK(ncp_buffer_active(buffer, 1.0, &channels) == 1);
    SAYS(channels, "{\"c\":{\"data\":[1.0],\"unit\":null}}");
    CHECK(ncp_buffer_active(buffer, 9.0, &channels) == 0 && channels == NULL);
    NO_CODE(ncp_buffer_on_frame(buffer, BYTES("{"), 1.0), "malformed");
    NO_CODE(ncp_buffer_on_frame(buffer, NULL, 0, 1.0), "missing");
    NO_CODE(ncp_buffer_on_frame(NULL, BYTES("{"), 1.0), "missing");
    NO_CODE(ncp_buffer_active(buffer, 1.0, NULL), "missing");
    NO_CODE(ncp_buffer_active(NULL, 1.0, &channels), "missing");
    CHECK(ncp_buffer_is_stopped(buffer) == 0);
    CHECK(ncp_buffer_on_frame(buffer, BYTES("{\"kind\":\"command_frame\",\"mode\":\"estop\","), 1.0) == 1);
    CHECK(ncp_buffer_is_stopped(buffer) == 1);
    CHECK(ncp_buffer_reset(buffer) == 1 && ncp_buffer_is_stopped(buffer) == 0);
    NO_CODE(ncp_buffer_is_stopped(NULL), "missing");
    NO_CODE(ncp_buffer_reset(NULL), "missing");
    CHECK(ncp_max_horizon_len(100.0, 20.0) == 5);
    CHECK(ncp_max_horizon_len(NAN, 20.0) == 0);

    CHECK(ncp_link_on_frame(monitor, 1) == 1 && ncp_link_on_frame(monitor, 3) == 1);
    CHECK(ncp_link_report(monitor, &report) == 1 && report.last_seq == 3 && report.received == 2 &&
          report.lost == 1 && report.burst);
    NO_CODE(ncp_link_on_frame(NULL, 1), "missing");
    NO_CODE(ncp_link_report(NULL, &report), "missing");
    NO_CODE(ncp_link_report(monitor, NULL), "missing");

    ncp_governor_free(governor);
    ncp_governor_free(negotiated);
    ncp_watchdog_free(watchdog);
    ncp_buffer_free(buffer);
    ncp_link_free(monitor);
    ncp_governor_free(NULL);
    ncp_watchdog_free(NULL);
    ncp_buffer_free(NULL);
    ncp_link_free(NULL);
}

static void control(void) {
    char *command = (char *)"left over", *status = (char *)"left over";
    ncp_codec *codec = ncp_codec_new("\"uav\"");
    ncp_reflex *reflex = ncp_reflex_new("{\"target\":[1,0,0]}");
    ncp_loop *loop = ncp_loop_new(50.0, "{}", "{}");
    ncp_service *service = ncp_service_new();

    SAYS(ncp_codec_encode(codec, NULL), "\"err_x\":100.0");
    SAYS(ncp_codec_decode(codec, "{\"vel_x\":\"NaN\"}", 1.0, 1, NULL, NULL), "[0.0,0.0,0.0]");
    NO_TEXT(ncp_codec_new(NULL), "missing");
    CHECK(ncp_codec_new("\"dragonfly\"") == NULL && ncp_codec_new(BAD) == NULL);
    NO_TEXT(ncp_codec_encode(NULL, NULL), "missing");
    NO_TEXT(ncp_codec_encode(codec, BAD), "malformed");
    NO_TEXT(ncp_codec_decode(codec, NULL, 1.0, 1, NULL, NULL), "missing");
    NO_TEXT(ncp_codec_decode(codec, "{}", 1.0, 1, NULL, BAD), "malformed");

    SAYS(ncp_reflex_step(reflex, 1.0, NULL), "\"mode\":\"hold\"");
    NO_TEXT(ncp_reflex_new("{\"kp\":-1}"), "value");
    NO_TEXT(ncp_reflex_new(NULL), "missing");
    NO_TEXT(ncp_reflex_step(NULL, 1.0, NULL), "missing");
    NO_TEXT(ncp_reflex_step(reflex, 1.0, BAD), "malformed");

    CHECK(ncp_loop_on_sensor(loop, SENSOR, 1.0) == 1);
    CHECK(ncp_loop_on_sensor(loop, SENSOR, 1.0) == 0);
    CHECK(ncp_loop_tick(loop, 1.0, 0.0, &command, &status) == 1);
    SAYS(command, "\"mode\":\"hold\"");
    SAYS(status, "\"seq\":1");
    NO_CODE(ncp_loop_tick(NULL, 1.0, 0.0, &command, &status), "missing");
    CHECK(command == NULL && status == NULL);
    NO_CODE(ncp_loop_tick(loop, 1.0, 0.0, NULL, &status), "missing");
    NO_CODE(ncp_loop_on_sensor(loop, NULL, 1.0), "missing");
    CHECK(ncp_loop_reset(loop) == 1);
    NO_CODE(ncp_loop_reset(NULL), "missing");
    NO_TEXT(ncp_loop_new(0.0, "{}", "{}"), "value");
    NO_TEXT(ncp_loop_new(50.0, NULL, "{}"), "missing");
    NO_TEXT(ncp_loop_new(50.0, "{}", BAD), "malformed");

    SAYS(ncp_service_serve(service, BYTES("{")), "\"kind\":\"error\"");
    NO_TEXT(ncp_service_serve(service, NULL, 0), "missing");
    NO_TEXT(ncp_service_serve(NULL, BYTES("{")), "missing");

    ncp_codec_free(codec);
    ncp_reflex_free(reflex);
    ncp_loop_free(loop);
    ncp_service_free(service);
    ncp_codec_free(NULL);
    ncp_reflex_free(NULL);
    ncp_loop_free(NULL);
    ncp_service_free(NULL);
}

int main(void) {
    seed();
    wire();
    bulk();
    safety();
    control();
    printf("%d failures\n", failures);
    return failures != 0;
}
